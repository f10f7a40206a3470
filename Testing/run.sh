#!/bin/bash
# SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
# SPDX-License-Identifier: BSD-3-Clause
#
# Usage: bash Testing/run.sh [--on <suite>] [--vtk-only] [-L <label>] [-LE <label>] [-E <name>]
#
# Install what is missing (Debian 12, 13 or 14), build, install into build/install, and run the tests
# without a screen. build/ has the system's VTK. Where ParaView is built on that, too (Debian 14), the
# plugin is in build/; where it has a VTK of its own, it is in build-paraview/. The last lines are
# ctest's own, and are in build/summary.txt; the exit status is 0 if all passed.
#
#   --on <suite>   do all this in that Debian: bookworm, trixie or forky. Where this one is another, it
#                  is in build-<suite>/root, and its build trees beside it: see CMake/debian-root.sh
#   --vtk-only     leave ParaView out
#   --sanitizers   instead: compile with AddressSanitizer and UndefinedBehaviorSanitizer into
#                  build-sanitizers/, and run a short form of the tests in C++. With GODRAYS_LONG=1 all of
#                  them, and those of filters with ThreadSanitizer and VTK's threads of its own, as it does
#                  not see how TBB's wait, in build-threads/
#   -L <label>     only tests with a label that matches this: see Testing/CMakeLists.txt. Only what these need is
#                  built: programs of tests in C++, examples and the program, ParaView's plugin
#   -LE <label>    only tests without it
#   -E <name>      only tests whose names do not match this

set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

die() { echo "Testing/run.sh: $*" >&2; exit 1; }

on=
paraview=true
sanitizers=false
options=()
selection=()
while [ $# -gt 0 ]; do
  case $1 in
    --on) [ $# -gt 1 ] || die "--on needs a suite: bookworm, trixie or forky."
          on=$2; shift ;;
    --vtk-only) paraview=false; options+=("$1") ;;
    --sanitizers) sanitizers=true; options+=("$1") ;;
    -L | -LE) [ $# -gt 1 ] || die "$1 needs a label, such as: $1 math"
        selection+=("$1" "$2"); shift ;;
    -E) [ $# -gt 1 ] || die "-E needs a part of tests' names, such as: -E Fuzz"
        selection+=("$1" "$2"); shift ;;
    *) die "unknown option $1; there are --on <suite>, --vtk-only, --sanitizers, -L and -LE <label>, -E <name>." ;;
  esac
  shift
done

. CMake/packages.sh

# A clone in another folder gets what ccache has from this one.
export CCACHE_BASEDIR=$PWD CCACHE_NOHASHDIR=true

if [ -n "$on" ] && [ "$on" != "$suite" ]; then
  exec bash CMake/debian-root.sh "$on" bash Testing/run.sh "${options[@]}" "${selection[@]}"
fi

times=
took() # <stage>: tell how long it took, since the last one
{
  times+="${times:+, }$1 $((SECONDS - begun)) s"
  echo "== $1: $((SECONDS - begun)) s"
  begun=$SECONDS
}
begun=$SECONDS

is_selected() # <label> <selection>...
{
  local label=$1
  shift
  while [ $# -gt 0 ]; do
    case $1 in
      -L) [[ $label =~ $2 ]] || return 1 ;;
      -LE) if [[ $label =~ $2 ]]; then return 1; fi ;;
    esac
    shift 2
  done
}

has_tests() # <label>...: whether tests with one of these labels are selected
{
  local label
  for label in "$@"; do
    if is_selected "$label" "${selection[@]}"; then return 0; fi
  done
  return 1
}

# The examples, the program and ParaView's plugin are built only for tests of them.
examples=OFF
if has_tests cli consumer example fuzzing package plugin portability; then examples=ON; fi
if ! has_tests consumer package plugin; then paraview=false; fi

# ---------------------------------------------------------------------------------------------
# Packages

packages=("${build_packages[@]}" "${configure_packages[@]}" "${test_packages[@]}")
if $paraview && ! $sanitizers; then
  packages+=("${paraview_packages[@]}")
fi
install_packages "${packages[@]}"
took packages

# ---------------------------------------------------------------------------------------------
# With sanitizers: a fault ends a program, which has run all tests otherwise.

sanitize() # <preset> <program>=<tests>...
{
  local preset=$1 each targets=() files= filters=
  shift
  for each in "$@"; do
    targets+=("${each%%=*}")
  done
  if [ -z "${GODRAYS_LONG:-}" ]; then
    files="TestGodRaysFaults;TestGodRaysReadBack;TestGodRaysResources"
    filters="TestGodRaysPowerSum;TestGodRaysSun;TestGodRaysHDRWriter;TestGodRaysCloudLayerSource"
    filters+=";TestGodRaysFireSource;TestGodRaysSmokeSource;TestGodRaysTerrainSource;TestGodRaysGridMedium"
  fi
  echo "== Building: $preset"
  cmake --preset "$preset" -DGODRAYS_BUILD_TESTING=ON -DGODRAYS_BUILD_EXAMPLES=OFF \
    -DGODRAYS_RENDERING_TESTS="$files" -DGODRAYS_FILTERS_TESTS="$filters"
  cmake --build --preset "$preset" --target "${targets[@]}"
  took "building $preset"
  for each in "$@"; do
    echo "== Testing: $preset, ${each%%=*}"
    xvfb-run -a -s "-screen 0 1280x1024x24 -noreset" "build-$preset/bin/${each%%=*}" \
      --gtest_brief=1 --gtest_filter="${each#*=}" >"build-$preset/tests.log" 2>&1 &&
      tail -n 1 "build-$preset/tests.log" || { cat "build-$preset/tests.log"; status=1; }
  done
  took "tests of $preset"
}

if $sanitizers; then
  status=0
  if [ -n "${GODRAYS_LONG:-}" ]; then
    sanitize sanitizers "godrays_math_tests=*" "godrays_filters_tests=*" "godrays_rendering_tests=*"
    export VTK_SMP_BACKEND_IN_USE=STDThread VTK_SMP_MAX_THREADS=4
    sanitize threads "godrays_filters_tests=*"
  else
    sanitize sanitizers "godrays_math_tests=*" "godrays_filters_tests=*" "godrays_rendering_tests=*"
  fi
  echo
  echo "== $suite, sanitizers: $times"
  exit "$status"
fi

# ---------------------------------------------------------------------------------------------
# Build. What is to be tested is named: CMake would leave out what it does not find. Programs of tests that are
# left out are not built.

# With CI=true, build-paraview is tested with plugin, packages, consumers and style alone, for time: its VTK is
# of the version in build.
paraview_selection=()
if [ "${CI:-}" = true ]; then
  paraview_selection=(-L "plugin|package|consumer|style")
fi

find_tests_in_cxx() # <selection>...: the labels that it selects, as a list of CMake's
{
  local label list=none
  for label in math filters rendering benchmark; do
    if is_selected "$label" "$@"; then list+=";$label"; fi
  done
  echo "$list"
}

build() # <preset> <argument>... for the configuration
{
  echo "== Building: $1"
  cmake --preset "$1" -DGODRAYS_BUILD_TESTING=ON -DGODRAYS_BUILD_EXAMPLES=$examples \
    "-DGODRAYS_TESTS_IN_CXX=$(find_tests_in_cxx "${selection[@]}")" "${@:2}"
  cmake --build --preset "$1"
  took "building $1"
}

make_paraview_root() # <folder>
{
  local command=(bash CMake/paraview-root.sh "$1")
  "${command[@]}" || { apt_get update; "${command[@]}"; } # its download needs fresh lists
}

trees=(build)
rm -f build/summary.txt
if $paraview && $paraview_shares_vtk; then
  make_paraview_root build/paraview
  build dev -DGODRAYS_WRAP_PYTHON=ON -DGODRAYS_BUILD_PARAVIEW_PLUGIN=ON \
    -DGODRAYS_BUILD_PARAVIEW_PANEL=$paraview_panel \
    -DParaView_DIR="$PWD/build/paraview/usr/lib/native/cmake/paraview"
else
  build dev -DGODRAYS_WRAP_PYTHON=ON -DGODRAYS_BUILD_PARAVIEW_PLUGIN=OFF
fi
cmake --install build --prefix build/install >build/install.log ||
  die "the installation into build/install failed: see build/install.log"
if $paraview && ! $paraview_shares_vtk; then
  make_paraview_root build-paraview/root
  tests=$(find_tests_in_cxx "${selection[@]}" "${paraview_selection[@]}")
  if [ "$tests" = none ]; then examples=OFF; fi
  build paraview -DGODRAYS_BUILD_PARAVIEW_PANEL=$paraview_panel "-DGODRAYS_TESTS_IN_CXX=$tests"
  trees+=(build-paraview)
fi

# ---------------------------------------------------------------------------------------------
# Test, all trees under one X server. -noreset: without it, the server restarts when its last
# client leaves, and a client that comes at that moment is turned away.

run_ctest='
failed=0
jobs=$1
trees=$2
paraview_label=$3
shift 3
for tree in $trees; do
  echo "== Testing: $tree"
  if [ -n "$paraview_label" ] && [ "$tree" = build-paraview ]; then
    set -- "$@" -L "$paraview_label"
  fi
  ctest --test-dir "$tree" --output-on-failure -j "$jobs" "$@" 2>&1 | tee "$tree/ctest.log"
  [ "${PIPESTATUS[0]}" -eq 0 ] || failed=1
done
exit $failed'

# As many tests run side by side as there are processors: threads of Mesa's own would only get into the way of
# other tests. On two processors 82 of them take 151 s without these, and 205 s with them.
export LP_NUM_THREADS=${LP_NUM_THREADS:-0}
status=0
xvfb-run -a -s "-screen 0 1280x1024x24 -noreset" \
  bash -c "$run_ctest" run_ctest "$(nproc)" "${trees[*]}" "${paraview_selection[1]:-}" "${selection[@]}" || status=$?
took tests

echo
echo "== $suite: $times"
for tree in "${trees[@]}"; do
  vtk=$(sed -n 's/^VTK_DIR:[A-Z]*=/VTK from /p' "$tree/CMakeCache.txt")
  echo "== $suite, $tree, $vtk"
  grep -E '\((Skipped|Not Run|Disabled)\)$' "$tree/ctest.log" || true
  grep -E 'tests passed, |No tests were found' "$tree/ctest.log" || echo "ctest did not finish"
done | tee build/summary.txt
exit "$status"
