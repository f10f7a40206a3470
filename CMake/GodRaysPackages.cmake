# SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
# SPDX-License-Identifier: BSD-3-Clause

# Debian packages, one for each component that is built, by CPack:
#   cpack --config build/CPackConfig.cmake      into build/packages
# What the libraries in a package need is found by dpkg-shlibdeps, so that packages are for the Debian on
# which they are made.

# A tree with the plugin and the VTK of ParaView makes one package, in a folder of its own. A tree that has
# the plugin and the system's VTK makes none: its libraries would need ParaView.

if(GODRAYS_BUILD_PARAVIEW_PLUGIN AND NOT godrays_vtk_in_paraview)
  message(STATUS "No Debian packages from this tree: configure another with "
    "-DGODRAYS_BUILD_PARAVIEW_PLUGIN=OFF")
  return()
endif()

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME godrays)
set(CPACK_PACKAGE_VERSION "${PROJECT_VERSION}")
set(CPACK_PACKAGE_CONTACT "the vtkGodRays authors <authors@vtkgodrays.invalid>")
set(CPACK_PACKAGE_VENDOR "the vtkGodRays authors")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "${PROJECT_DESCRIPTION}")
set(CPACK_RESOURCE_FILE_LICENSE "${PROJECT_SOURCE_DIR}/LICENSE")
set(CPACK_PACKAGE_DIRECTORY "${CMAKE_BINARY_DIR}/packages")
set(CPACK_OUTPUT_FILE_PREFIX "${CMAKE_BINARY_DIR}/packages")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_THREADS 0)

set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_RELEASE 1)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS_PRIVATE_DIRS "${CMAKE_BINARY_DIR}/lib")
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
set(CPACK_COMPONENTS_GROUPING IGNORE)

# godrays_package(<component> NAME <package> SECTION <section> SUMMARY <words> DESCRIPTION <text>
#   [DEPENDS <list, as in a control file>])
function(godrays_package component)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "NAME;SECTION;SUMMARY;DESCRIPTION;DEPENDS" "")
  string(TOUPPER "${component}" upper)
  foreach(field IN ITEMS NAME SECTION DEPENDS)
    set(CPACK_DEBIAN_${upper}_PACKAGE_${field} "${arg_${field}}" PARENT_SCOPE)
  endforeach()
  set(CPACK_COMPONENT_${upper}_DESCRIPTION "${arg_SUMMARY}\n${arg_DESCRIPTION}" PARENT_SCOPE)
  set(CPACK_COMPONENTS_ALL ${CPACK_COMPONENTS_ALL} ${component} PARENT_SCOPE)
  install(FILES "${PROJECT_SOURCE_DIR}/LICENSE" # in packages alone
    DESTINATION "share/doc/${arg_NAME}"
    COMPONENT   ${component}
    RENAME      copyright
    EXCLUDE_FROM_ALL)
endfunction()

set(library "libgodrays${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR}")
set(same "= ${PROJECT_VERSION}-1")
set(vtk "${VTK_MAJOR_VERSION}.${VTK_MINOR_VERSION}")

if(godrays_vtk_in_paraview)
  set(CPACK_PACKAGING_INSTALL_PREFIX /usr/lib/paraview-godrays) # /usr/lib may have libraries of these names
  set(CPACK_COMPONENTS_GROUPING ALL_COMPONENTS_IN_ONE)
  set(CPACK_DEB_COMPONENT_INSTALL OFF)
  set(CPACK_INSTALL_CMAKE_PROJECTS
    "${CMAKE_BINARY_DIR};${PROJECT_NAME};runtime;/"
    "${CMAKE_BINARY_DIR};${PROJECT_NAME};python;/"
    "${CMAKE_BINARY_DIR};${PROJECT_NAME};paraview_plugins;/")
  set(CPACK_PACKAGE_NAME paraview-godrays)
  set(CPACK_DEBIAN_PACKAGE_SECTION graphics)
  include(CPack)
  return()
endif()

godrays_package(runtime
  NAME        ${library}
  SECTION     libs
  SUMMARY     "god rays for VTK scenes: libraries"
  DESCRIPTION "A render pass of VTK ${vtk} that adds light shafts to scenes, filters of images, and a sky.")
godrays_package(development
  NAME        libgodrays-dev
  SECTION     libdevel
  DEPENDS     "${library} (${same}), libvtk9-dev, libglew-dev, libgl-dev"
  SUMMARY     "god rays for VTK scenes: headers and CMake's package"
  DESCRIPTION "For find_package(GodRays) with VTK ${vtk}.")
if(GODRAYS_WRAP_PYTHON)
  godrays_package(python
    NAME        python3-godrays
    SECTION     python
    DEPENDS     "${library} (${same}), python3, python3-vtk9, python3-numpy"
    SUMMARY     "god rays for VTK scenes: the Python module godrays"
    DESCRIPTION "For the Python of VTK ${vtk}: renderers, plotters of PyVista and vedo, and arrays of NumPy.")
endif()
if(GODRAYS_BUILD_EXAMPLES)
  godrays_package(program
    NAME        godrays
    SECTION     graphics
    DEPENDS     "${library} (${same})"
    SUMMARY     "god rays for VTK scenes: a viewer"
    DESCRIPTION "Reads what VTK reads, and shows it, or writes a picture, with light shafts.")
endif()
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SHLIBDEPS OFF)
set(CPACK_DEBIAN_PACKAGE_GENERATE_SHLIBS ON)
set(CPACK_DEBIAN_PACKAGE_GENERATE_SHLIBS_POLICY "=")

include(CPack)
