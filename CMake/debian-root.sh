#!/bin/bash
# SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
# SPDX-License-Identifier: BSD-3-Clause
#
# Usage: debian-root.sh <suite> <command> [<argument>...]
#
# Run a command as root in another Debian: bookworm, trixie or forky, in a root of its own in
# build-<suite>/root. It is made at first, with debootstrap and the mirror of apt's own sources, or that
# of the variable DEBIAN_MIRROR. There the source tree is /godrays, and the command runs in it. Its build
# trees are those in build-<suite>/, not those of this system; ccache's folder is the same.
#
# The mounts are in a mount namespace of the command's own. Outside there are none, and build-<suite> can
# be deleted at any time.

set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

die() { echo "debian-root.sh: $*" >&2; exit 1; }

[ $# -ge 2 ] || die "a suite and a command are needed, such as: forky bash Testing/run.sh"
case $1 in
  bookworm | trixie | forky) ;;
  *) die "there is no suite $1: name bookworm, trixie or forky." ;;
esac
[ "$(id -u)" -eq 0 ] || die "a root of another Debian can only be made and used by root. Run this as root."
unshare --mount true || die "mounts cannot be made here. In a container: start it with all privileges."

. CMake/packages.sh

mkdir -p "build-$1"
folder=$(cd "build-$1" && pwd -P) # a link in the copy of the tree that .ci/run makes
root=$folder/root
made=$root/etc/godrays-root # written when debootstrap has finished
other=$1
shift

# Commands share the root, and each holds the lock until it ends. Only one that is alone makes or mends the root.
exec 9>"$folder/root.lock"
is_alone=true
flock --nonblock 9 || is_alone=false
$is_alone || flock --shared --nonblock 9 || {
  echo "== Waiting for another run, which makes or mends $root"
  flock --shared 9
}

# ---------------------------------------------------------------------------------------------
# The root. One that debootstrap did not finish is made anew, and so is one whose packages were left
# half installed and do not come right.

find_mirror()
{
  apt-get indextargets --format '$(REPO_URI)' 'Created-By: Packages' 'Origin: Debian' 'Label: Debian' |
    awk '/^http/ && !found { print; found = 1 } END { exit !found }'
}

# Whether something is mounted below the root. A blank in a path is \040 in /proc/self/mounts.
has_mounts()
{
  local target
  while read -r _ target _; do
    printf -v target %b "$target"
    [[ $target != "$root"/* ]] || return 0
  done </proc/self/mounts
  return 1
}

make_root()
{
  if [ -e "$root" ]; then
    ! has_mounts ||
      die "something is mounted in $root, which is to be made anew. Unmount it; findmnt lists it."
    echo "== $root is unfinished, and is made anew"
    rm -rf --one-file-system "$root"
  fi
  install_packages debootstrap
  local mirror=${DEBIAN_MIRROR:-}
  [ -n "$mirror" ] || mirror=$(find_mirror) || { apt_get update; mirror=$(find_mirror); } ||
    die "apt's sources name no mirror of Debian. Name one with DEBIAN_MIRROR=<URL>."
  local script=() # an older debootstrap does not know the names of later suites
  [ -e "/usr/share/debootstrap/scripts/$other" ] || script=(sid)
  echo "== Making $root"
  # debootstrap leaves dependencies out if the path has a blank. It gets another path of the same folder.
  local plain succeeded=true
  mkdir "$root"
  plain=$(mktemp -d /tmp/debian-root.XXXXXX)
  unshare --mount bash -c 'mount --bind "$1" "$2" && exec "${@:3}"' debian-root.sh "$root" "$plain" \
    debootstrap --variant=minbase "$other" "$plain" "$mirror" "${script[@]}" \
    >"$folder/debootstrap.log" 2>&1 || succeeded=false
  rmdir "$plain"
  $succeeded || die "debootstrap failed: see $folder/debootstrap.log"

  # apt's ways to the mirror are those of this system. What dpkg writes need not survive a power cut.
  apt-config dump | grep -E '^Acquire::(Check-Date|Check-Valid-Until|Retries|[^ ]*Proxy[^ ]*) ' \
    >"$root/etc/apt/apt.conf.d/90godrays" || true
  echo force-unsafe-io >"$root/etc/dpkg/dpkg.cfg.d/godrays"
  touch "$made"
}

left_half_installed() { [ -n "$(chroot "$root" dpkg --audit 2>&1)" ]; }

if $is_alone; then
  if [ -f "$made" ] && left_half_installed; then
    chroot "$root" env DEBIAN_FRONTEND=noninteractive dpkg --configure -a </dev/null || true
    ! left_half_installed || rm "$made"
  fi
  [ -f "$made" ] || make_root
  flock --shared 9
fi
[ -f "$made" ] || die "another run did not finish $root. Run this again."

# ---------------------------------------------------------------------------------------------
# The command

cp --dereference --remove-destination /etc/resolv.conf /etc/hosts "$root/etc/"

cache=$(ccache --get-config cache_dir 2>/dev/null) || cache=${XDG_CACHE_HOME:-$HOME/.cache}/ccache
trees=(build build-paraview build-release build-sanitizers build-threads build-wheel) # CMakePresets.json's, TestWheel's
mkdir -p "$cache" "$root/godrays" "$root/ccache" "${trees[@]}" "${trees[@]/#/$folder/}"

environment=(HOME=/root CCACHE_DIR=/ccache PATH=/usr/sbin:/usr/bin:/sbin:/bin LC_ALL=C.UTF-8)
for name in CI TERM GODRAYS_LONG GODRAYS_SEED CCACHE_DISABLE http_proxy https_proxy no_proxy; do
  [ -z "${!name:-}" ] || environment+=("$name=${!name}")
done

mount_and_run='
set -eu
root=$1 folder=$2 cache=$3 trees=$4
shift 4
mount --bind "$PWD" "$root/godrays"
for tree in $trees; do
  mount --bind "$folder/$tree" "$root/godrays/$tree"
done
mount --bind "$cache" "$root/ccache"
mount -t proc proc "$root/proc"
mount --rbind /sys "$root/sys"
mount --rbind /dev "$root/dev"
exec chroot "$root" env -i --chdir=/godrays "$@"'

exec unshare --mount bash -c "$mount_and_run" debian-root.sh \
  "$root" "$folder" "$cache" "${trees[*]}" "${environment[@]}" "$@"
