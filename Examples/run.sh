#!/bin/bash
# SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
# SPDX-License-Identifier: BSD-3-Clause
#
# Usage: bash Examples/run.sh
#
# Install what is missing (Debian 12), build into build/, and make pictures of real data and of all
# examples in build/examples/, without a screen. Needs no ParaView.

set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

die() { echo "Examples/run.sh: $*" >&2; exit 1; }

# ---------------------------------------------------------------------------------------------
# Packages. apt-get runs only when one is missing.

packages=(
  g++ cmake ninja-build ccache
  libvtk9-dev python3-vtk9 libglm-dev libhwy-dev libcli11-dev libgtest-dev libbenchmark-dev
  xvfb xauth libgl1-mesa-dri
  python3-numpy python-matplotlib-data assimp-testmodels) # the last two: elevations and a mesh

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
  apt_get install -y --no-install-recommends "${missing[@]}"
fi

# ---------------------------------------------------------------------------------------------
# Build

echo "== Building"
cmake --preset dev -DPython3_EXECUTABLE=/usr/bin/python3
cmake --build --preset dev

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
# Pictures, all under one X server. -noreset: without it, the server restarts when its last client
# leaves, and a client that comes at that moment is turned away.

export PYTHONPATH=build/lib/python3/dist-packages${PYTHONPATH:+:$PYTHONPATH}
export out mesh

make_pictures='
set -eu
show() # <picture> <argument>... for godrays
{
  picture=$out/$1.png
  shift
  echo "$picture: build/bin/godrays $*"
  build/bin/godrays "$@" --output "$picture" --stats >"${picture%.png}.txt"
}
show jacksboro "$out/data/jacksboro.vti"
show jacksboro-without-rays "$out/data/jacksboro.vti" --no-rays
show topobathy "$out/data/topobathy.vts" --elevation-scale 10
show engine "$mesh"
show engine-before-a-lamp "$mesh" --light 90,-40,-300 --light-size 25
for name in ColouredLights DustyHall Facade MinimalSun Outdoor Planet SkyImage Statue Sunrise \
  TaggedOccluders TwoViewports; do
  echo "$out/$name.png: build/bin/$name"
  build/bin/$name "$out/$name.png"
  echo "$out/$name-python.png: /usr/bin/python3 Examples/$name/$name.py"
  /usr/bin/python3 Examples/$name/$name.py "$out/$name-python.png"
done
echo "$out/Outdoor-baked.png: build/bin/Outdoor baked"
build/bin/Outdoor "$out/Outdoor-baked.png" baked'

echo "== Pictures"
xvfb-run -a -s "-screen 0 1280x1024x24 -noreset" bash -c "$make_pictures" ||
  die "a picture could not be made: see the messages above."

cat <<END

The pictures are in $PWD/$out. Beside those of godrays, a .txt file each says what was drawn and how.
Heights are exaggerated: Jacksboro's fivefold (chosen by godrays), those of topobathy tenfold.

To look around in a window, run a command above in a desktop session as it stands, in this folder:
  cd $PWD
  export PYTHONPATH=build/lib/python3/dist-packages
  build/bin/godrays $out/data/jacksboro.vti
END
