# SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
# SPDX-License-Identifier: BSD-3-Clause
# shellcheck shell=bash disable=SC2034 # others use the lists
#
# For scripts to read in, after they have defined die(): Debian's packages, one list for each purpose,
# and how they are installed.

# shellcheck disable=SC1091
suite=$(. /etc/os-release && echo "${VERSION_CODENAME:-}")

build_packages=(
  g++ cmake ninja-build ccache
  libvtk9-dev python3-vtk9 python3-numpy libglm-dev libhwy-dev libcli11-dev libopenexr-dev
  xvfb xauth libgl1-mesa-dri)
configure_packages=(libgtest-dev libbenchmark-dev) # CMake asks for them, even if no test is built
example_packages=(python-matplotlib-data assimp-testmodels) # elevations and a mesh
test_packages=(python3-vedo mypy dpkg-dev file python3-venv python3-myst-parser python3-sphinx-rtd-theme)
paraview_packages=(paraview paraview-dev openmpi-bin)

# Where ParaView has a VTK of its own, python3-paraview and python3-vtk9 exclude each other: the trailing
# "-" leaves the former out. The icons of ParaView's window need libqt5svg5 or qt6-svg-plugins.
# paraview_panel is whether the plugin's part that needs Qt, for ParaView's panel, must be built
# (GODRAYS_BUILD_PARAVIEW_PANEL): with the development files of that Qt.
paraview_shares_vtk=false
paraview_panel=AUTO
case $suite in
  bookworm) # Debian 12
    test_packages+=(libvtk9-qt-dev clang-format-14 clang-14 libclang-rt-14-dev g++-mingw-w64-x86-64-posix
      invesalius-examples mricron-data pymol-data chromium-driver python3-selenium)
    paraview_packages+=(libqt5svg5 qtbase5-dev python3-paraview-)
    paraview_panel=ON ;;
  trixie) # Debian 13
    test_packages+=(python3-pyvista)
    paraview_packages+=(qt6-svg-plugins python3-paraview-) ;;
  forky) # Debian 14
    test_packages+=(python3-pyvista python3-scikit-build-core python3-auditwheel patchelf)
    paraview_packages+=(qt6-svg-plugins qt6-base-dev qt6-5compat-dev qt6-tools-dev libvtk9-qt-dev python3-paraview)
    paraview_panel=ON
    paraview_shares_vtk=true ;;
  *)
    die "this system, ${suite:-which /etc/os-release does not name}, is not known: packages are listed for
  Debian's bookworm, trixie and forky. On another system, install what CMake asks for, and build by hand
  as in README.md." ;;
esac

apt_get() # <argument>... as root
{
  local as_root=()
  if [ "$(id -u)" -ne 0 ]; then
    command -v sudo >/dev/null ||
      die "this needs root, and there is no sudo: apt-get $*. Run it as root, and this again."
    as_root=(sudo)
  fi
  "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get -q -o DPkg::Lock::Timeout=600 "$@" \
    </dev/null || die "apt-get $1 failed: see its messages above."
}

# Install what is missing; apt-get runs only then. A package with a trailing "-" is not to be there.
install_packages() # <package>...
{
  local missing=() unwanted=() package status
  for package in "$@"; do
    case $package in
      *-) unwanted+=("$package") ;;
      *) status=$(dpkg-query -W -f '${db:Status-Status}' "$package" 2>/dev/null) || status=none
         [ "$status" = installed ] || missing+=("$package") ;;
    esac
  done
  if [ ${#missing[@]} -gt 0 ]; then
    echo "== Installing ${missing[*]}"
    apt_get update
    apt_get install -y --no-install-recommends "${missing[@]}" "${unwanted[@]}"
  fi
}
