# SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
# SPDX-License-Identifier: BSD-3-Clause

# godrays_add_example(<Name>)
#
# Build Examples/<Name>/<Name>.cxx as the program build/bin/<Name>, and run it as a test. An
# example takes one optional argument: the PNG file to write. Without it, it opens a window. If
# there is also a <Name>.py, it is the same example in Python, and runs as a test in the same way.
function(godrays_add_example name)
  set(components
    CommonColor CommonCore CommonDataModel FiltersCore FiltersGeneral FiltersModeling
    FiltersSources IOGeometry IOImage IOLegacy IOPLY IOXML InteractionStyle RenderingCore
    RenderingFreeType RenderingOpenGL2 RenderingUI RenderingVolumeOpenGL2)
  find_package(VTK REQUIRED COMPONENTS ${components})
  list(TRANSFORM components PREPEND VTK::)

  set(folder "${CMAKE_CURRENT_SOURCE_DIR}/${name}")
  if(EXISTS "${folder}/${name}.cxx")
    add_executable(${name} "${folder}/${name}.cxx")
    target_link_libraries(${name} PRIVATE GodRays::Rendering ${components})
    target_compile_options(${name} PRIVATE ${godrays_warnings})
    vtk_module_autoinit(TARGETS ${name} MODULES ${components})
    set(command_cxx $<TARGET_FILE:${name}>)
  endif()
  if(EXISTS "${folder}/${name}.py" AND GODRAYS_WRAP_PYTHON)
    set(command_py "${Python3_EXECUTABLE}" "${folder}/${name}.py")
  endif()

  if(GODRAYS_BUILD_TESTING)
    foreach(language IN ITEMS cxx py)
      if(command_${language})
        set(picture "${CMAKE_CURRENT_BINARY_DIR}/${name}_${language}.png")
        add_test(NAME example.${name}.${language}
          COMMAND "${CMAKE_COMMAND}" "-DPICTURE=${picture}"
            -P "${PROJECT_SOURCE_DIR}/CMake/GodRaysRunExample.cmake" -- ${command_${language}})
        set_tests_properties(example.${name}.${language} PROPERTIES
          LABELS      example
          TIMEOUT     300
          ENVIRONMENT "PYTHONPATH=${CMAKE_BINARY_DIR}/${godrays_python_destination}")
      endif()
    endforeach()
  endif()
endfunction()
