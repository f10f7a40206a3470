# SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
# SPDX-License-Identifier: BSD-3-Clause

include(GoogleTest)

# godrays_add_test_program(<name>
#   LABEL     <label>
#   SOURCES   <file>...
#   LIBRARIES <target>...)
#
# A GoogleTest program whose cases are tests of their own, under one label. With an empty list of
# sources there is no program. Tests may include private headers of the modules.
function(godrays_add_test_program name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "LABEL" "SOURCES;LIBRARIES")
  if(NOT arg_SOURCES)
    return()
  endif()
  add_executable(${name} ${arg_SOURCES})
  target_link_libraries(${name} PRIVATE ${arg_LIBRARIES} glm::glm)
  target_compile_options(${name} PRIVATE ${godrays_warnings})
  target_include_directories(${name} PRIVATE "${CMAKE_CURRENT_SOURCE_DIR}")
  if(GODRAYS_SANITIZERS)
    target_sources(${name} PRIVATE "${PROJECT_SOURCE_DIR}/Testing/Sanitizers.cxx")
  endif()
  # PRE_TEST: the cases are asked for when the tests run, not while the program is built.
  gtest_discover_tests(${name}
    DISCOVERY_MODE PRE_TEST
    DISCOVERY_TIMEOUT 60
    TEST_PREFIX "${arg_LABEL}."
    PROPERTIES LABELS ${arg_LABEL} TIMEOUT 900)
endfunction()

# godrays_add_python_test(<name> LABEL <label> FILE <file.py> ENVIRONMENT <NAME=value>...)
#
# A Python file of unittest cases.
function(godrays_add_python_test name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "LABEL;FILE" "ENVIRONMENT")
  add_test(NAME ${name}
    COMMAND "${Python3_EXECUTABLE}" "${CMAKE_CURRENT_SOURCE_DIR}/${arg_FILE}" -v)
  set_tests_properties(${name} PROPERTIES
    LABELS      ${arg_LABEL}
    TIMEOUT     900
    ENVIRONMENT "${arg_ENVIRONMENT}")
endfunction()
