# SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
# SPDX-License-Identifier: BSD-3-Clause

# godrays_find_paraview()
#
# After find_package(VTK): find the ParaView that is built on that VTK. It is the one in ParaView_DIR, if
# that is set, or else the one whose package stands beside VTK's and has no VTK of its own. A ParaView with
# its own VTK is no choice: two VTKs must not meet in a program.
#
# Where files of ParaView's package are missing, it stops CMake. Somebody who wants the module alone must
# not be stopped: another process tries the package first, until
# it succeeds.
macro(godrays_find_paraview)
  if(NOT ParaView_DIR)
    unset(ParaView_DIR CACHE) # NOTFOUND of the last time
    file(GLOB godrays_configs "${VTK_DIR}/../paraview-*/paraview-config.cmake")
    foreach(config IN LISTS godrays_configs)
      cmake_path(GET config PARENT_PATH folder)
      cmake_path(NORMAL_PATH folder)
      if(NOT EXISTS "${folder}/vtk/vtk-config.cmake")
        set(ParaView_DIR "${folder}")
      endif()
    endforeach()
  endif()
  if(ParaView_DIR)
    godrays_probe_paraview("${ParaView_DIR}")
    if(GODRAYS_PARAVIEW_PROBED STREQUAL ParaView_DIR)
      find_package(ParaView 5.11 QUIET
        COMPONENTS          RemotingViews
        OPTIONAL_COMPONENTS RemotingViewsPython)
    else()
      string(CONCAT ParaView_NOT_FOUND_MESSAGE "The ParaView of ${ParaView_DIR} cannot be used: see "
        "${CMAKE_BINARY_DIR}/ParaViewProbe/log.txt. In Debian, `bash CMake/paraview-root.sh <folder>` "
        "mends its package: then give -DParaView_DIR=<folder>/usr/lib/native/cmake/paraview.")
      message(STATUS "${ParaView_NOT_FOUND_MESSAGE}")
    endif()
  endif()
endmacro()

# Set GODRAYS_PARAVIEW_PROBED to the folder of ParaView's package if that can be used, and keep it.
function(godrays_probe_paraview folder)
  if(GODRAYS_PARAVIEW_PROBED STREQUAL folder)
    return()
  endif()
  set(binaries "${CMAKE_BINARY_DIR}/ParaViewProbe")
  file(MAKE_DIRECTORY "${binaries}")
  execute_process(
    COMMAND "${CMAKE_COMMAND}" -G "${CMAKE_GENERATOR}"
      -S "${CMAKE_CURRENT_FUNCTION_LIST_DIR}/ParaViewProbe" -B "${binaries}"
      "-DParaView_DIR=${folder}" "-DVTK_DIR=${VTK_DIR}" "-DCMAKE_PREFIX_PATH=${CMAKE_PREFIX_PATH}"
      "-DPython3_EXECUTABLE=${Python3_EXECUTABLE}"
    RESULT_VARIABLE failed
    OUTPUT_FILE     "${binaries}/log.txt"
    ERROR_FILE      "${binaries}/log.txt")
  if(NOT failed)
    set(GODRAYS_PARAVIEW_PROBED "${folder}" CACHE INTERNAL "The folder of a ParaView that can be used")
  endif()
endfunction()
