#!/bin/bash
# SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
# SPDX-License-Identifier: BSD-3-Clause
#
# Usage: bash Testing/run.sh [--vtk-only] [-L <label>]
#
# Install what is missing (Debian 12), build against the system's VTK in build/ and against the
# VTK inside ParaView in build-paraview/, install the former into build/install, and run the tests
# of both without a screen. The last lines are ctest's own; the exit status is 0 if all passed.
#
#   --vtk-only   leave ParaView out
#   -L <label>   only tests with this label: see Testing/CMakeLists.txt

set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

die() { echo "Testing/run.sh: $*" >&2; exit 1; }

paraview=true
selection=()
while [ $# -gt 0 ]; do
  case $1 in
    --vtk-only) paraview=false ;;
    -L) [ $# -gt 1 ] || die "-L needs a label, such as: -L math"
        selection+=(-L "$2"); shift ;;
    *) die "unknown option $1; there are --vtk-only and -L <label>." ;;
  esac
  shift
done

# ---------------------------------------------------------------------------------------------
# Packages. apt-get runs only when one is missing.

packages=(
  g++ cmake ninja-build ccache clang-format-14
  libvtk9-dev python3-vtk9 python3-numpy libglm-dev libhwy-dev libcli11-dev libgtest-dev
  libbenchmark-dev
  xvfb xauth libgl1-mesa-dri)
if $paraview; then
  packages+=(paraview paraview-dev openmpi-bin libqt5svg5) # the last: the icons of its window
fi

missing=()
for package in "${packages[@]}"; do
  status=$(dpkg-query -W -f '${db:Status-Status}' "$package" 2>/dev/null) || status=none
  [ "$status" = installed ] || missing+=("$package")
done

apt_get() # <argument>... as root
{
  local as_root=()
  if [ "$(id -u)" -ne 0 ]; then
    command -v sudo >/dev/null ||
      die "this needs root, and there is no sudo: apt-get $*. Run it as root, and this again."
    as_root=(sudo)
  fi
  "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get -q -o DPkg::Lock::Timeout=600 "$@" ||
    die "apt-get $1 failed: see its messages above."
}

if [ ${#missing[@]} -gt 0 ]; then
  echo "== Installing ${missing[*]}"
  apt_get update
  # python3-paraview and python3-vtk9 exclude each other: the trailing "-" leaves the former out.
  apt_get install -y --no-install-recommends "${missing[@]}" python3-paraview-
fi

# ---------------------------------------------------------------------------------------------
# Build

build() # <preset>
{
  echo "== Building: $1"
  cmake --preset "$1"
  cmake --build --preset "$1"
}

trees=(build)
build dev
cmake --install build --prefix build/install >build/install.log ||
  die "the installation into build/install failed: see build/install.log"
if $paraview; then
  make_root=(bash CMake/paraview-root.sh build-paraview/root)
  "${make_root[@]}" || { apt_get update; "${make_root[@]}"; } # its download needs fresh lists
  build paraview
  trees+=(build-paraview)
fi

# ---------------------------------------------------------------------------------------------
# Test, all trees under one X server. -noreset: without it, the server restarts when its last
# client leaves, and a client that comes at that moment is turned away.

run_ctest='
failed=0
jobs=$1
trees=$2
shift 2
for tree in $trees; do
  echo "== Testing: $tree"
  ctest --test-dir "$tree" --output-on-failure -j "$jobs" "$@" 2>&1 | tee "$tree/ctest.log"
  [ "${PIPESTATUS[0]}" -eq 0 ] || failed=1
done
exit $failed'

status=0
xvfb-run -a -s "-screen 0 1280x1024x24 -noreset" \
  bash -c "$run_ctest" run_ctest "$(nproc)" "${trees[*]}" "${selection[@]}" || status=$?

echo
for tree in "${trees[@]}"; do
  echo "== $tree, $(sed -n 's/^VTK_DIR:[A-Z]*=/VTK from /p' "$tree/CMakeCache.txt")"
  grep -E 'tests passed, |No tests were found' "$tree/ctest.log" || echo "ctest did not finish"
done
exit "$status"
