# SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
# SPDX-License-Identifier: BSD-3-Clause

# godrays_add_example(<Name> [WITHOUT_RAYS])
#
# Build Examples/<Name>/<Name>.cxx as the program build/bin/<Name>, and test it and its twin in
# Python, <Name>.py, if there is one: each draws Testing/Baseline/Example-<Name>.png. An example
# takes two arguments, the PNG file to write and its size, such as 400x300; without the first, it opens a
# window.
#
# godrays_add_example(<Name> <variant>...): with a third argument, <variant>, it draws
# Testing/Baseline/Example-<Name>-<variant>.png. If there are Testing/Examples/Test<Name>.cxx and
# .py, they test what else the example does, as in its window; Test<Name>.py gets the script and the
# program, and leaves its files where it runs. They are the only tests of an example WITHOUT_RAYS.
#
# Pictures are within 2 levels of 255 of their baselines, or of Example-<Name>_1.png of another version of
# VTK: splats of vtkPointGaussianMapper have another shape since VTK 9.4.
function(godrays_add_example name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "WITHOUT_RAYS" "" "")
  set(components
    CommonColor CommonCore CommonDataModel CommonExecutionModel FiltersCore FiltersExtraction FiltersGeneral
    FiltersGeometry FiltersHybrid FiltersModeling FiltersSources IOGeometry IOImage IOImport IOLegacy
    IOOggTheora IOPLY IOXML ImagingCore ImagingSources InteractionStyle InteractionWidgets RenderingCore
    RenderingFreeType RenderingOpenGL2 RenderingUI RenderingVolumeOpenGL2 vtksys)
  find_package(VTK REQUIRED COMPONENTS ${components})
  list(TRANSFORM components PREPEND VTK::)

  set(source "${CMAKE_CURRENT_SOURCE_DIR}/${name}/${name}.cxx")
  set(script "${CMAKE_CURRENT_SOURCE_DIR}/${name}/${name}.py")
  set(tests "${PROJECT_SOURCE_DIR}/Testing")

  add_executable(${name} "${source}")
  set(programs ${name})
  set(added)
  if(GODRAYS_BUILD_TESTING AND NOT arg_WITHOUT_RAYS)
    # The example itself, in a program that looks at what it draws
    add_executable(test_${name}
      "${tests}/Examples/TestExample.cxx" "${tests}/Rendering/GodRaysMediumTruth.cxx")
    target_include_directories(test_${name} PRIVATE "${tests}/Rendering")
    target_compile_definitions(test_${name} PRIVATE
      EXAMPLE_NAME="${name}" EXAMPLE_SOURCE="${source}")
    list(APPEND programs test_${name})
    foreach(variant IN ITEMS "" ${arg_UNPARSED_ARGUMENTS})
      set(test ${name})
      if(variant)
        set(test ${name}-${variant})
      endif()
      set(baseline "${tests}/Baseline/Example-${test}.png")
      add_test(NAME example.${test}.cxx COMMAND test_${name}
        "${CMAKE_CURRENT_BINARY_DIR}/${test}_cxx.png" "${baseline}" ${variant})
      list(APPEND added example.${test}.cxx)
      if(EXISTS "${script}" AND godrays_test_python)
        add_test(NAME example.${test}.py
          COMMAND "${Python3_EXECUTABLE}" "${tests}/Examples/test_example.py" "${script}"
            "${CMAKE_CURRENT_BINARY_DIR}/${test}_py.png" "${baseline}" ${variant})
        list(APPEND added example.${test}.py)
      endif()
    endforeach()
  endif()
  if(GODRAYS_BUILD_TESTING AND EXISTS "${tests}/Examples/Test${name}.cxx")
    find_package(GTest REQUIRED)
    add_executable(test_${name}_use "${tests}/Examples/Test${name}.cxx")
    target_link_libraries(test_${name}_use PRIVATE GTest::gtest_main)
    list(APPEND programs test_${name}_use)
    add_test(NAME example.${name}.use.cxx COMMAND test_${name}_use)
    list(APPEND added example.${name}.use.cxx)
  endif()
  if(GODRAYS_BUILD_TESTING AND EXISTS "${tests}/Examples/Test${name}.py" AND godrays_test_python)
    add_test(NAME example.${name}.use.py
      COMMAND "${Python3_EXECUTABLE}" "${tests}/Examples/Test${name}.py" "${script}"
        "$<TARGET_FILE:${name}>")
    list(APPEND added example.${name}.use.py)
  endif()
  if(added)
    set_tests_properties(${added} PROPERTIES
      LABELS      example
      TIMEOUT     300
      ENVIRONMENT "PYTHONPATH=${CMAKE_BINARY_DIR}/${godrays_python_destination}")
  endif()

  foreach(program IN LISTS programs)
    target_link_libraries(${program}
      PRIVATE GodRays::Filters GodRays::Rendering GodRays::Sources ${components})
    target_include_directories(${program} PRIVATE "${CMAKE_CURRENT_SOURCE_DIR}")
    target_compile_options(${program} PRIVATE ${godrays_warnings})
    vtk_module_autoinit(TARGETS ${program} MODULES ${components})
  endforeach()
endfunction()
