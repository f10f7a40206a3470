# SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
# SPDX-License-Identifier: BSD-3-Clause

# ParaView's programs, and its Python, which need not be installed where Python looks.
set(godrays_paraview_bin "${ParaView_PREFIX_PATH}/bin")
set(godrays_paraview_python "${ParaView_PREFIX_PATH}/${PARAVIEW_PYTHONPATH}")

foreach(program IN ITEMS paraview pvbatch pvserver mpirun Xvfb)
  string(TOUPPER "GODRAYS_${program}" variable)
  find_program(${variable} ${program} HINTS "${godrays_paraview_bin}"
    DOC "${program}, for tests of the plugin")
  mark_as_advanced(${variable})
  if(NOT ${variable})
    message(FATAL_ERROR "${program} was not found, and the tests of the plugin need it. Install it "
      "(Debian: paraview, openmpi-bin, xvfb), name it with -D${variable}=<file>, or configure with "
      "-DGODRAYS_BUILD_TESTING=OFF.")
  endif()
endforeach()

set(godrays_plugin_environment
  "GODRAYS_PLUGIN=$<TARGET_FILE:GodRays>"
  "GODRAYS_PARAVIEW=${GODRAYS_PARAVIEW}"
  "GODRAYS_PVBATCH=${GODRAYS_PVBATCH}"
  "GODRAYS_PVSERVER=${GODRAYS_PVSERVER}"
  "GODRAYS_MPIRUN=${GODRAYS_MPIRUN}"
  "GODRAYS_XVFB=${GODRAYS_XVFB}"
  "GODRAYS_BASELINES=${PROJECT_SOURCE_DIR}/Testing/Baseline"
  "GODRAYS_TEMPORARY=${CMAKE_BINARY_DIR}/Testing/Plugin")
file(MAKE_DIRECTORY "${CMAKE_BINARY_DIR}/Testing/Plugin")
list(JOIN godrays_paraview_python ":" python_path)
string(PREPEND python_path "${CMAKE_BINARY_DIR}/${godrays_python_destination}:"
  "${PROJECT_SOURCE_DIR}/Testing/Plugin:")
list(APPEND godrays_plugin_environment "PYTHONPATH=${python_path}")

# godrays_add_plugin_test(<name> FILE <file.py> [PROGRAM <program>])
#
# A Python file that pvbatch runs, or another program; see Testing/Plugin/plugin_testing.py.
function(godrays_add_plugin_test name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "FILE;PROGRAM" "")
  if(NOT arg_PROGRAM)
    set(arg_PROGRAM "${GODRAYS_PVBATCH}")
  endif()
  add_test(NAME ${name} COMMAND "${arg_PROGRAM}" "${CMAKE_CURRENT_SOURCE_DIR}/${arg_FILE}")
  set_tests_properties(${name} PROPERTIES
    LABELS      plugin
    TIMEOUT     600
    ENVIRONMENT "${godrays_plugin_environment}")
endfunction()
