# SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
# SPDX-License-Identifier: BSD-3-Clause

# The libraries alone: vcpkg install godrays --overlay-ports=CMake/Packaging/vcpkg
set(SOURCE_PATH "${CMAKE_CURRENT_LIST_DIR}/../../..")
vcpkg_cmake_configure(
  SOURCE_PATH "${SOURCE_PATH}"
  OPTIONS
    -DGODRAYS_BUILD_EXAMPLES=OFF
    -DGODRAYS_BUILD_PARAVIEW_PLUGIN=OFF
    -DGODRAYS_BUILD_TESTING=OFF
    -DGODRAYS_WRAP_PYTHON=OFF)
vcpkg_cmake_install()
vcpkg_cmake_config_fixup(PACKAGE_NAME GodRays CONFIG_PATH lib/cmake/GodRays)
file(REMOVE_RECURSE "${CURRENT_PACKAGES_DIR}/debug/include" "${CURRENT_PACKAGES_DIR}/debug/share")
vcpkg_install_copyright(FILE_LIST "${SOURCE_PATH}/LICENSE")
