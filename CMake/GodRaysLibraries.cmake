# SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
# SPDX-License-Identifier: BSD-3-Clause

include(FetchContent)

option(GODRAYS_FETCH_LIBRARIES "Download and build GLM, Highway and CLI11 if they are not installed"
  "${SKBUILD}")

# godrays_find_library(<package> <target> <Debian package> <repository> <commit>)
#
# Finds a library that has CMake's package and target. Where it is not installed, builds it from the commit
# of its repository if GODRAYS_FETCH_LIBRARIES is on, and fails otherwise.
function(godrays_find_library package target debian_package repository commit)
  find_package(${package} QUIET GLOBAL)
  if(NOT TARGET ${target} AND GODRAYS_FETCH_LIBRARIES)
    message(STATUS "${package} was not found, and is taken from ${repository}")
    set(BUILD_SHARED_LIBS OFF)
    set(BUILD_TESTING OFF)
    set(CMAKE_POSITION_INDEPENDENT_CODE ON)
    set(CMAKE_POLICY_DEFAULT_CMP0077 NEW) # options are the variables that are set here
    foreach(part IN ITEMS CONTRIB EXAMPLES INSTALL TESTS) # of Highway
      set(HWY_ENABLE_${part} OFF)
    endforeach()
    FetchContent_Declare(${package} GIT_REPOSITORY "${repository}" GIT_TAG ${commit} EXCLUDE_FROM_ALL)
    FetchContent_MakeAvailable(${package})
    if(NOT TARGET ${target})
      add_library(${target} ALIAS ${package})
    endif()
  endif()
  if(NOT TARGET ${target})
    message(FATAL_ERROR "${package} was not found. Install it (Debian: ${debian_package}), name the folder "
      "of its CMake package with -D${package}_DIR=<folder>, or have it downloaded with "
      "-DGODRAYS_FETCH_LIBRARIES=ON.")
  endif()
endfunction()
