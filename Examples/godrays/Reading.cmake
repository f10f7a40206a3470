# SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
# SPDX-License-Identifier: BSD-3-Clause

# The target godrays_reading: what makes props of files, for the program and for godrays.render() of Python.
# There is none if VTK lacks a module.

set(godrays_reading_components
  CommonColor CommonCore CommonDataModel CommonExecutionModel CommonMath CommonMisc
  FiltersCore FiltersGeneral FiltersGeometry ImagingCore ImagingMath
  IOExodus IOGeometry IOImage IOImport IOLegacy IOPLY IOXML IOXMLParser
  RenderingCore RenderingOpenGL2 RenderingVolume RenderingVolumeOpenGL2)
find_package(VTK QUIET COMPONENTS ${godrays_reading_components} tiff vtksys)
list(TRANSFORM godrays_reading_components PREPEND VTK:: OUTPUT_VARIABLE godrays_reading_modules)
if(VTK_FOUND AND NOT TARGET godrays_reading)
  set(sources
    Coloring.cxx
    Colormaps.cxx
    DataChecks.cxx
    Elevation.cxx
    FileChecks.cxx
    Files.cxx
    GltfFile.cxx
    GltfImporter.cxx
    ImageHeaders.cxx
    Json.cxx
    Messages.cxx
    ObjMaterials.cxx
    Outliers.cxx
    PlyStrips.cxx
    Progress.cxx
    Scene.cxx
    SceneMaker.cxx
    Series.cxx
    System.cxx
    Temporary.cxx
    TiffPicture.cxx
    UpAxis.cxx
    Values.cxx
    Volumes.cxx)
  list(TRANSFORM sources PREPEND "${CMAKE_CURRENT_LIST_DIR}/")
  find_package(Threads REQUIRED)
  add_library(godrays_reading OBJECT ${sources})
  set_target_properties(godrays_reading PROPERTIES POSITION_INDEPENDENT_CODE ON)
  target_include_directories(godrays_reading PUBLIC "${CMAKE_CURRENT_LIST_DIR}")
  target_link_libraries(godrays_reading PUBLIC GodRays::Filters GodRays::Rendering Threads::Threads
    ${godrays_reading_modules} VTK::tiff VTK::vtksys)
  target_compile_options(godrays_reading PRIVATE ${godrays_warnings})
  vtk_module_autoinit(TARGETS godrays_reading MODULES ${godrays_reading_modules})
  if(WIN32)
    target_link_libraries(godrays_reading PUBLIC shlwapi)
  endif()
endif()
