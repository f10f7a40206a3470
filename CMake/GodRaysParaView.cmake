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
        OPTIONAL_COMPONENTS RemotingViewsPython pqComponents)
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

# godrays_find_panel(<variable>)
#
# After godrays_find_paraview(): find what ParaView's own widgets are linked to, and set a variable to what of
# it is missing, in words; it is empty if the plugin GodRaysPanel can be built. The packages of ParaView and
# VTK find only what those components need that are asked for.
function(godrays_find_panel result)
  set(${result} "ParaView's component pqComponents. ${ParaView_pqComponents_NOT_FOUND_MESSAGE}" PARENT_SCOPE)
  if(NOT TARGET ParaView::pqComponents)
    return()
  endif()
  foreach(again IN ITEMS FALSE TRUE)
    set(targets ParaView::pqComponents)
    set(seen "")
    set(missing "")
    set(modules "") # of VTK that name what is missing
    while(targets)
      list(POP_FRONT targets target)
      list(APPEND seen "${target}")
      set(properties INTERFACE_LINK_LIBRARIES)
      get_target_property(configurations "${target}" IMPORTED_CONFIGURATIONS)
      foreach(configuration IN LISTS configurations)
        list(APPEND properties "IMPORTED_LINK_DEPENDENT_LIBRARIES_${configuration}")
      endforeach()
      foreach(property IN LISTS properties)
        get_target_property(linked "${target}" "${property}")
        string(REGEX MATCHALL "[A-Za-z0-9_]+::[A-Za-z0-9_]+" linked "${linked}")
        foreach(each IN LISTS linked)
          if(TARGET "${each}" AND NOT each IN_LIST seen AND NOT each IN_LIST targets)
            list(APPEND targets "${each}")
            set("needed_by_${each}" "${target}")
          elseif(NOT TARGET "${each}" AND property STREQUAL "INTERFACE_LINK_LIBRARIES")
            list(APPEND missing "${each}")
            foreach(module IN ITEMS "${target}" "${needed_by_${target}}") # VTK's xdmf3 finds for vtkxdmfcore
              if(module MATCHES "^VTK::(.*)")
                list(APPEND modules "${CMAKE_MATCH_1}")
              endif()
            endforeach()
          endif()
        endforeach()
      endforeach()
    endwhile()
    if(modules AND NOT again)
      find_package(VTK QUIET OPTIONAL_COMPONENTS ${modules})
    endif()
  endforeach()
  set(header vtkEventQtSlotConnect.h) # of VTK::GUISupportQt, which can be there without it
  set(has_header FALSE)
  if(TARGET VTK::GUISupportQt)
    get_target_property(folders VTK::GUISupportQt INTERFACE_INCLUDE_DIRECTORIES)
    list(TRANSFORM folders REPLACE "^\\$<BUILD_INTERFACE:(.*)>$" "\\1")
    foreach(folder IN LISTS folders)
      if(EXISTS "${folder}/${header}")
        set(has_header TRUE)
      endif()
    endforeach()
  endif()
  if(NOT has_header)
    list(APPEND missing "${header}")
  endif()
  list(REMOVE_DUPLICATES missing)
  list(JOIN missing ", " missing)
  set(${result} "${missing}" PARENT_SCOPE)
endfunction()

# godrays_write_entries(<variable>)
#
# Write ParaView's XML of all classes, from their headers and from Plugin/Views/*.xml.in, and set a variable
# to the files. CMake runs again when a header or a template changes. It needs Python, but no ParaView.
function(godrays_write_entries result)
  set(writer "${PROJECT_SOURCE_DIR}/CMake/write_entries.py")
  set(classes "")
  foreach(list suffix IN ZIP_LISTS "models;integrators;algorithms" "Model;Integrator;")
    get_property(stems GLOBAL PROPERTY "godrays_${list}")
    list(TRANSFORM stems REPLACE ".*/(.*)" "vtkGodRays\\1${suffix}")
    list(APPEND classes ${stems})
  endforeach()
  list(JOIN classes "," classes)
  file(GLOB templates CONFIGURE_DEPENDS "${PROJECT_SOURCE_DIR}/Plugin/Views/*.xml.in")
  if(NOT Python3_EXECUTABLE)
    find_package(Python3 REQUIRED COMPONENTS Interpreter)
  endif()
  file(MAKE_DIRECTORY "${godrays_entries}")
  execute_process(
    COMMAND "${Python3_EXECUTABLE}" "${writer}"
      "${PROJECT_SOURCE_DIR}" "${godrays_entries}" "${classes}" ${templates}
    RESULT_VARIABLE failed
    OUTPUT_VARIABLE headers
    ERROR_VARIABLE  problem
    OUTPUT_STRIP_TRAILING_WHITESPACE)
  if(failed)
    message(FATAL_ERROR "ParaView's XML cannot be written.\n${problem}")
  endif()
  string(REPLACE "\n" ";" headers "${headers}")
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${headers} ${templates} "${writer}")
  list(TRANSFORM templates REPLACE ".*/(.*)[.]in" "${godrays_entries}/\\1")
  set(${result} ${templates} PARENT_SCOPE)
endfunction()
