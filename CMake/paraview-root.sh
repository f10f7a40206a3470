#!/bin/bash
# SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
# SPDX-License-Identifier: BSD-3-Clause
#
# Usage: paraview-root.sh <root>
#
# Make a private root of ParaView with CMake files that can be used; those of Debian's packages cannot:
#   - Where ParaView has a VTK of its own (Debian 12 and 13), its package python3-paraview excludes
#     python3-vtk9, but its CMake files need it. The root holds it, unpacked.
#   - They name Python modules without the tag that Debian gives to such files (Debian 13 and 14). The
#     root's copy of them has the true names.
# Everything else in the root is a link; nothing outside of it changes.
#
# -DParaView_DIR=<root>/usr/lib/native/cmake/paraview is then ParaView, and -DVTK_DIR=<the same>/vtk
# the VTK inside it, if there is one.

set -euo pipefail

die() { echo "paraview-root.sh: $*" >&2; exit 1; }

[ $# -eq 1 ] || die "one argument is needed: the folder to make."

version=$(dpkg-query -W -f '${Version}' paraview-dev 2>/dev/null) ||
  die "the package paraview-dev is not installed. On Debian 12 and 13 install it without python3-paraview:
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
cp -r "$cmake_files" "$root$libraries/cmake/"
if [ "$(dpkg-query -W -f '${Version}' python3-paraview 2>/dev/null)" = "$version" ]; then
  ln -sfn /usr/lib/python3 "$root/usr/lib/python3"
else
  (cd "$root" &&
    apt-get -qq -o APT::Sandbox::User="$(id -un)" download "python3-paraview=$version") ||
    die "python3-paraview $version could not be downloaded. Run apt-get update as root, and see that
  the machine has a network."
  dpkg-deb --extract "$root"/python3-paraview_*.deb "$root"
  rm "$root"/python3-paraview_*.deb
fi
tag=$(/usr/bin/python3 -c 'import sysconfig; print(sysconfig.get_config_var("EXT_SUFFIX"))')
{ grep -rhoE 'lib/python3/dist-packages/[^"]*\.so' "$root$libraries/cmake/$name" || true; } | sort -u |
  while read -r module; do
    true_name=${module%.so}$tag
    if [ ! -e "$root/usr/$module" ] && [ -e "$root/usr/$true_name" ]; then
      echo "s|/$module\"|/$true_name\"|"
    fi
  done >"$root/names.sed"
find "$root$libraries/cmake/$name" -name '*-targets-*.cmake' -exec sed -i -f "$root/names.sed" {} +
if [ -d "$libraries/vtk" ]; then
  cp -rs --no-clobber "$libraries/vtk" "$root$libraries/"
fi
# The library of mathematics stays the system's alone: CMake warns of another where programs look for libraries.
find "$libraries" -mindepth 1 -maxdepth 1 ! -name cmake ! -name vtk ! -name 'libm.*' \
  -exec ln -sfn -t "$root$libraries" {} +
ln -sfn "/usr/include/$name" "$root/usr/include/$name"
find /usr/bin \( -name "*pv${name#paraview-}*" -o -name 'pvbatch*' -o -name 'pvpython*' -o -name 'pv*server' \
  -o -name 'paraview*' \) -exec ln -sfn -t "$root/usr/bin" {} +
# The wrapping tools of ParaView's VTK
tools=$(dpkg -L paraview paraview-dev | grep '^/usr/bin/vtk' || true)
for tool in $tools; do
  ln -sfn -t "$root/usr/bin" "$tool"
done

# A path without the names of the architecture and the version. It is as long as the true one:
# the CMake files count folders upwards to find what they belong to.
ln -sfn "$(basename "$libraries")" "$root/usr/lib/native"
ln -sfn "$name" "$root$libraries/cmake/paraview"
echo "$version" > "$root/version"
