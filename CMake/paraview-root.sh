#!/bin/bash
# SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
# SPDX-License-Identifier: BSD-3-Clause
#
# Usage: paraview-root.sh <root>
#
# Make a private root of ParaView that CMake can use beside the system's VTK. On Debian 12 the
# packages python3-paraview and python3-vtk9 exclude each other, and ParaView's CMake files fail
# without the former. The root holds a copy of these CMake files, the unpacked python3-paraview,
# and links to everything else; nothing outside of it changes.
#
# -DParaView_DIR=<root>/usr/lib/native/cmake/paraview is then ParaView, and -DVTK_DIR=<the same>/vtk
# the VTK inside it.

set -euo pipefail

die() { echo "paraview-root.sh: $*" >&2; exit 1; }

[ $# -eq 1 ] || die "one argument is needed: the folder to make."

version=$(dpkg-query -W -f '${Version}' paraview-dev 2>/dev/null) ||
  die "the package paraview-dev is not installed. Install it without python3-paraview:
  apt-get install --no-install-recommends paraview-dev python3-paraview-"

root=$1
if [ "$(cat "$root/version" 2>/dev/null)" = "$version" ]; then
  exit 0 # made before
fi
if [ -e "$root" ]; then
  [ -f "$root/version" ] ||
    die "$root exists, and was not made by this script. Name another folder."
  rm -rf "$root"
fi
mkdir -p "$root"
echo unfinished > "$root/version"
root=$(cd "$root" && pwd)

cmake_files=$(dpkg -L paraview-dev | grep -i '/paraview-\?config.cmake$') ||
  die "the package paraview-dev has no CMake files: it is damaged. Reinstall it."
cmake_files=$(dirname "$cmake_files") # /usr/lib/<architecture>/cmake/paraview-<version>
libraries=$(dirname "$(dirname "$cmake_files")")
name=$(basename "$cmake_files")

mkdir -p "$root$libraries/cmake" "$root/usr/bin" "$root/usr/include"
(cd "$root" &&
  apt-get -qq -o APT::Sandbox::User="$(id -un)" download "python3-paraview=$version") ||
  die "python3-paraview $version could not be downloaded. Run apt-get update as root, and see that
  the machine has a network."
dpkg-deb --extract "$root"/python3-paraview_*.deb "$root"
rm "$root"/python3-paraview_*.deb

cp -r "$cmake_files" "$root$libraries/cmake/"
if [ -d "$libraries/vtk" ]; then
  cp -rs --no-clobber "$libraries/vtk" "$root$libraries/"
fi
find "$libraries" -mindepth 1 -maxdepth 1 ! -name cmake ! -name vtk \
  -exec ln -sfn -t "$root$libraries" {} +
ln -sfn "/usr/include/$name" "$root/usr/include/$name"
find /usr/bin \( -name "*pv${name#paraview-}*" -o -name 'pvbatch*' -o -name 'pv*server' \
  -o -name 'paraview*' \) -exec ln -sfn -t "$root/usr/bin" {} +
# The wrapping tools of ParaView's VTK
for tool in $(dpkg -L paraview paraview-dev | grep '^/usr/bin/vtk'); do
  ln -sfn -t "$root/usr/bin" "$tool"
done

# A path without the names of the architecture and the version. It is as long as the true one:
# the CMake files count folders upwards to find what they belong to.
ln -sfn "$(basename "$libraries")" "$root/usr/lib/native"
ln -sfn "$name" "$root$libraries/cmake/paraview"
echo "$version" > "$root/version"
