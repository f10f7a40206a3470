# SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
# SPDX-License-Identifier: BSD-3-Clause

# godrays_encode_shaders(<sources> <headers> <file.glsl>...)
#
# Turn each GLSL file, in whatever folder it is, into a C++ string that is named like the file:
# Blend/vtkGodRaysBlendFS.glsl becomes `extern const char* vtkGodRaysBlendFS`, declared in
# vtkGodRaysBlendFS.h. The generated files are appended to the two lists. The strings are private
# to the library.
function(godrays_encode_shaders sources headers)
  foreach(shader IN LISTS ARGN)
    cmake_path(GET shader STEM name)
    vtk_encode_string(
      INPUT         "${shader}"
      NAME          "${name}"
      HEADER_OUTPUT header
      SOURCE_OUTPUT source)
    list(APPEND ${sources} "${source}")
    list(APPEND ${headers} "${header}")
  endforeach()
  return(PROPAGATE ${sources} ${headers})
endfunction()
