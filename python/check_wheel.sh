#!/usr/bin/env bash
# Copyright (c) 2026 The Intrinsic Triangulations authors
# SPDX-License-Identifier: GPL-3.0-or-later
#
# usage: python/check_wheel.sh BUILD_DIRECTORY
# Makes a wheel from what a build directory has, installs it into an empty environment, and runs
# ten tasks where GMP and MPFR of the system cannot be read. Needs root, or user namespaces.
set -euo pipefail

root=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")/.." && pwd)
INTRINSIC_TRIANGULATIONS_BUILD_DIR=$(cd -- "$1" && pwd)
export INTRINSIC_TRIANGULATIONS_BUILD_DIR
work=$(mktemp -d)
trap 'rm -rf -- "$work"' EXIT

/usr/bin/python3 -m venv --system-site-packages "$work/env"
export PATH="$work/env/bin:$PATH"
pip wheel --no-build-isolation --no-index --no-deps --wheel-dir "$work/built" "$root"
python "$root/python/bundle_libraries.py" "$work"/built/*.whl "$work"
pip install --no-index --no-deps "$work"/*.whl

user=()
((EUID == 0)) || user=(--user --map-root-user)
cd -- "$work"
unshare "${user[@]}" --mount bash -c '
  set -euo pipefail
  for name in gmp mpfr; do
    for file in /usr/lib/*/lib$name.so.*; do mount --bind /dev/null "$(realpath "$file")"; done
  done
  for file in env/lib/python3*/site-packages/intrinsic/{_core*.so,programs/*}; do
    if ldd "$file" | grep -E "not found|lib(gmp|mpfr).* => /usr"; then exit 1; fi
    [[ $(patchelf --print-rpath "$file") == "\$ORIGIN/"*intrinsic.libs ]]
  done
  python "$1"/python/tests/use_wheel.py' - "$root"
