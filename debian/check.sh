#!/usr/bin/env bash
# Copyright (c) 2026 The Intrinsic Triangulations authors
# SPDX-License-Identifier: GPL-3.0-or-later
#
# usage: debian/check.sh [BUILD_DIRECTORY]
# Builds the packages, from what a build directory has or from nothing, checks them with lintian,
# and runs debian/tests where they are installed: in an overlay of this system, which is thrown away.
# Needs root.
set -euo pipefail

root=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")/.." && pwd)
work=$(mktemp -d)
trap 'rm -rf -- "$work"' EXIT
if (($# > 0)); then
  INTRINSIC_TRIANGULATIONS_BUILD_DIR=$(cd -- "$1" && pwd)
  export INTRINSIC_TRIANGULATIONS_BUILD_DIR
fi

# in a copy, since packages go beside the sources
mkdir "$work/copy"
tar -C "$root" --exclude='./build*' --exclude=./results --exclude=./.git -c . | tar -C "$work/copy" -x
(cd -- "$work/copy" && dpkg-buildpackage -us -uc -b)
lintian --fail-on error,warning --tag-display-limit 0 "$work"/*.changes

mkdir "$work/mount"
unshare --mount bash -c '
  set -euo pipefail
  mount -t tmpfs none "$1/mount"
  mkdir "$1"/mount/{upper,work,all}
  mount -t overlay none -o "lowerdir=/,upperdir=$1/mount/upper,workdir=$1/mount/work" "$1/mount/all"
  mkdir "$1/mount/all/packages" "$1/mount/all/tests"
  cp "$1"/*.deb "$1/mount/all/packages"
  cp "$1"/copy/debian/tests/* "$1/mount/all/tests"
  mount --bind /proc "$1/mount/all/proc"
  mount --bind /dev "$1/mount/all/dev"
  exec chroot "$1/mount/all" bash -euc "
    dpkg -i /packages/*.deb
    for test in program module library; do
      export AUTOPKGTEST_TMP=\$(mktemp -d)
      /tests/\$test
      echo \"\$test: done\"
    done"
' - "$work"
