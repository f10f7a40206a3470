# SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
# SPDX-License-Identifier: BSD-3-Clause

# godrays_include_folders(<module> <folder>...)
#
# Headers of a module are included by name alone, in the source tree as where they are installed: flat.
function(godrays_include_folders module)
  foreach(folder IN LISTS ARGN)
    vtk_module_include(${module}
      PUBLIC "$<BUILD_INTERFACE:${CMAKE_CURRENT_SOURCE_DIR}/${folder}>")
  endforeach()
endfunction()
