# SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
# SPDX-License-Identifier: BSD-3-Clause

# godrays_add_example(<Name>)
#
# Build Examples/<Name>/<Name>.cxx as the program build/bin/<Name>, and test it and its twin in
# Python, <Name>.py, if there is one: each draws Testing/Baseline/Example-<Name>.png. An example
# takes one argument, the PNG file to write; without it, it opens a window.
function(godrays_add_example name)
  set(components
    CommonColor CommonCore CommonDataModel CommonExecutionModel FiltersCore FiltersGeneral
    FiltersModeling FiltersSources IOGeometry IOImage IOLegacy IOPLY IOXML InteractionStyle
    RenderingCore RenderingFreeType RenderingOpenGL2 RenderingUI RenderingVolumeOpenGL2)
  find_package(VTK REQUIRED COMPONENTS ${components})
  list(TRANSFORM components PREPEND VTK::)

  set(source "${CMAKE_CURRENT_SOURCE_DIR}/${name}/${name}.cxx")
  set(script "${CMAKE_CURRENT_SOURCE_DIR}/${name}/${name}.py")
  set(tests "${PROJECT_SOURCE_DIR}/Testing")
  set(baseline "${tests}/Baseline/Example-${name}.png")

  add_executable(${name} "${source}")
  set(programs ${name})
  if(GODRAYS_BUILD_TESTING)
    # The example itself, in a program that looks at what it draws
    add_executable(test_${name}
      "${tests}/Examples/TestExample.cxx" "${tests}/Rendering/GodRaysMediumTruth.cxx")
    target_include_directories(test_${name} PRIVATE "${tests}/Rendering")
    target_link_libraries(test_${name} PRIVATE GodRays::Filters)
    target_compile_definitions(test_${name} PRIVATE
      EXAMPLE_NAME="${name}" EXAMPLE_SOURCE="${source}")
    list(APPEND programs test_${name})
    add_test(NAME example.${name}.cxx
      COMMAND test_${name} "${CMAKE_CURRENT_BINARY_DIR}/${name}_cxx.png" "${baseline}")
    set(added example.${name}.cxx)
    if(EXISTS "${script}" AND godrays_test_python)
      add_test(NAME example.${name}.py
        COMMAND "${Python3_EXECUTABLE}" "${tests}/Examples/test_example.py" "${script}"
          "${CMAKE_CURRENT_BINARY_DIR}/${name}_py.png" "${baseline}")
      list(APPEND added example.${name}.py)
    endif()
    set_tests_properties(${added} PROPERTIES
      LABELS      example
      TIMEOUT     300
      ENVIRONMENT "PYTHONPATH=${CMAKE_BINARY_DIR}/${godrays_python_destination}")
  endif()

  foreach(program IN LISTS programs)
    target_link_libraries(${program} PRIVATE GodRays::Rendering ${components})
    target_include_directories(${program} PRIVATE "${CMAKE_CURRENT_SOURCE_DIR}")
    target_compile_options(${program} PRIVATE ${godrays_warnings})
    vtk_module_autoinit(TARGETS ${program} MODULES ${components})
  endforeach()
endfunction()
