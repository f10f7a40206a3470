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
  "GODRAYS_PARAVIEW=${GODRAYS_PARAVIEW}"
  "GODRAYS_PVBATCH=${GODRAYS_PVBATCH}"
  "GODRAYS_PVSERVER=${GODRAYS_PVSERVER}"
  "GODRAYS_MPIRUN=${GODRAYS_MPIRUN}"
  "GODRAYS_XVFB=${GODRAYS_XVFB}"
  "GODRAYS_BASELINES=${PROJECT_SOURCE_DIR}/Testing/Baseline"
  "GODRAYS_PANEL=$<TARGET_NAME_IF_EXISTS:GodRaysPanel>" # empty without Qt
  "GODRAYS_TEMPORARY=${CMAKE_BINARY_DIR}/Testing/Plugin")
file(MAKE_DIRECTORY "${CMAKE_BINARY_DIR}/Testing/Plugin")
list(JOIN godrays_paraview_python ":" godrays_plugin_python)
string(PREPEND godrays_plugin_python "${PROJECT_SOURCE_DIR}/Testing/Plugin:")

# The environment, with the plugin in a tree
macro(godrays_plugin_tree result plugin prefix)
  set(${result}
    ${godrays_plugin_environment}
    "GODRAYS_PLUGIN=${plugin}"
    "PYTHONPATH=${prefix}/${godrays_python_destination}:${godrays_plugin_python}")
endmacro()
godrays_plugin_tree(godrays_plugin_build_environment "$<TARGET_FILE:GodRays>" "${CMAKE_BINARY_DIR}")

# godrays_add_plugin_test(<name> FILE <file.py> [PROGRAM <program>] [INSTALLED <prefix>])
#
# A Python file that pvbatch runs, or another program; see Testing/Plugin/plugin_testing.py. The
# plugin is that of the build tree, or of the tree that the fixture godrays_installed makes.
function(godrays_add_plugin_test name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "FILE;PROGRAM;INSTALLED" "")
  if(NOT arg_PROGRAM)
    set(arg_PROGRAM "${GODRAYS_PVBATCH}")
  endif()
  set(environment ${godrays_plugin_build_environment})
  if(arg_INSTALLED)
    string(JOIN "/" plugin "${arg_INSTALLED}" "${CMAKE_INSTALL_LIBDIR}" "${PARAVIEW_PLUGIN_SUBDIR}"
      "GodRays" "$<TARGET_FILE_NAME:GodRays>")
    godrays_plugin_tree(environment "${plugin}" "${arg_INSTALLED}")
  endif()
  add_test(NAME ${name} COMMAND "${arg_PROGRAM}" "${CMAKE_CURRENT_SOURCE_DIR}/${arg_FILE}")
  set_tests_properties(${name} PROPERTIES
    LABELS      plugin
    TIMEOUT     1200
    ENVIRONMENT "${environment}")
  if(arg_INSTALLED)
    set_tests_properties(${name} PROPERTIES FIXTURES_REQUIRED godrays_installed)
  endif()
endfunction()
