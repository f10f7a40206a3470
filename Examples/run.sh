#!/bin/bash
# SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
# SPDX-License-Identifier: BSD-3-Clause
#
# Usage: bash Examples/run.sh [--on <suite>]
#
# Install what is missing (Debian 12, 13 or 14), build the program godrays and the examples in build/, and
# make pictures of real data and of all examples in build/examples/, without a screen. Needs no ParaView.
#
# build/ is configured as Testing/run.sh and `cmake --preset dev` do it, or as it was. Of it, only what
# makes pictures is built, and at first only what makes the first one.
#
#   --on <suite>   do all this in that Debian: bookworm, trixie or forky. Where this one is another, the pictures are
#                  in build-<suite>/build/examples: see CMake/debian-root.sh

set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

die() { echo "Examples/run.sh: $*" >&2; exit 1; }

examples=(
  ColouredLights DustyHall Facade MinimalSun Outdoor Planet SkyImage Statue Sunrise TaggedOccluders
  TwoViewports)

on=
case $# in
  0) ;;
  2) [ "$1" = --on ] || die "unknown option $1; there is --on <suite>."
     on=$2 ;;
  *) die "there is one option, --on <suite>, such as: --on forky" ;;
esac

. CMake/packages.sh
if [ -n "$on" ] && [ "$on" != "$suite" ]; then
  exec bash CMake/debian-root.sh "$on" bash Examples/run.sh
fi
install_packages "${build_packages[@]}" "${configure_packages[@]}" "${example_packages[@]}"
installed=$SECONDS

build() # <target>...
{
  cmake --build --preset dev --target "$@"
}

echo "== Building godrays"
cmake --preset dev -DGODRAYS_BUILD_EXAMPLES=ON -DGODRAYS_WRAP_PYTHON=ON
build godrays

# ---------------------------------------------------------------------------------------------
# Data

find_file() # <package> <end of the path>
{
  # All of the list is read: a reader that leaves early would make dpkg fail, now and then.
  local found
  found=$(dpkg -L "$1" | grep "$2\$") || die "package $1 has no file $2; install it again."
  echo "${found%%$'\n'*}"
}

echo "== Data"
elevations=$(find_file python-matplotlib-data /jacksboro_fault_dem.npz)
mesh=$(find_file assimp-testmodels /2CylinderEngine.glb)
out=build/examples
mkdir -p "$out/data"
/usr/bin/python3 Examples/make_terrain.py "$(dirname "$elevations")" "$out/data"

# ---------------------------------------------------------------------------------------------
# Pictures. -noreset: without it, the X server restarts when its last client leaves, and a client that
# comes at that moment is turned away.

export PYTHONPATH=build/lib/python3/dist-packages${PYTHONPATH:+:$PYTHONPATH}
export out mesh

make_pictures() # <commands> <argument>...
{
  local functions='
set -eu
show() # <picture> <argument>... for godrays
{
  picture=$out/$1.png
  shift
  echo "$picture: build/bin/godrays $*"
  build/bin/godrays "$@" --output "$picture" --stats >"${picture%.png}.txt"
}'
  xvfb-run -a -s "-screen 0 1280x1024x24 -noreset" bash -c "$functions$1" make_pictures "${@:2}" ||
    die "a picture could not be made: see the messages above."
}

echo "== Pictures"
make_pictures '
show jacksboro "$out/data/jacksboro.vti"'
echo "== The first picture, after $SECONDS s, of which $installed s to install: $PWD/$out/jacksboro.png"

echo "== Building the examples"
build "${examples[@]}" godrays_python

echo "== Pictures"
make_pictures '
show jacksboro-without-rays "$out/data/jacksboro.vti" --no-rays
show topobathy "$out/data/topobathy.vts" --elevation-scale 10
show engine "$mesh"
show engine-before-a-lamp "$mesh" --light 90,120,-300 --light-size 40
for name in "$@"; do
  echo "$out/$name.png: build/bin/$name"
  build/bin/$name "$out/$name.png"
  echo "$out/$name-python.png: /usr/bin/python3 Examples/$name/$name.py"
  /usr/bin/python3 Examples/$name/$name.py "$out/$name-python.png"
done
for mode in baked medium; do
  echo "$out/Outdoor-$mode.png: build/bin/Outdoor $mode"
  build/bin/Outdoor "$out/Outdoor-$mode.png" $mode
done' "${examples[@]}"

cat <<END

The pictures are in $PWD/$out. Beside those of godrays, a .txt file each says what was drawn and how.
Heights are exaggerated: Jacksboro's fivefold (chosen by godrays), those of topobathy tenfold.

To look around in a window, run a command above in a desktop session as it stands, in this folder:
  cd $(printf %q "$PWD")
  export PYTHONPATH=build/lib/python3/dist-packages
  build/bin/godrays $out/data/jacksboro.vti
END
