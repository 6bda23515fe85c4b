#!/usr/bin/env bash
# Copyright (c) 2026 The Intrinsic Triangulations authors
# SPDX-License-Identifier: GPL-3.0-or-later
#
# usage: [RESULTS=DIR] examples/run.sh [MESH]
# From a bare Debian 12 to the exact intrinsic Delaunay triangulation of MESH and its Laplacian:
# installs what is missing, builds the program `intrinsic`, runs it. MESH is any file that CGAL
# reads, by default the part with bad triangles that comes along. Results go to RESULTS, by default
# results/ in the root of the repository.
set -euo pipefail

root=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")/.." && pwd)
if (($# > 1)) || [[ "${1:-}" == -* ]]; then
  sed -n '5,10s/^# \{0,1\}//p' "${BASH_SOURCE[0]}" >&2
  exit 2
fi
mesh=${1:-$root/examples/data/part.off}
results=${RESULTS:-$root/results}
build=$root/build/release

if [[ ! -r "$mesh" ]]; then
  echo "$mesh: cannot be read; give the path of a mesh file" >&2
  exit 1
fi

bash "$root/cmake/install_dependencies.sh" \
  g++ cmake ninja-build libcgal-dev libgmp-dev libmpfr-dev libboost-dev \
  libeigen3-dev libspectra-dev libcli11-dev nlohmann-json3-dev libjs-three

if [[ ! -f "$build/build.ninja" ]]; then # else keep what was chosen, such as to build the tests
  (cd -- "$root" && cmake --preset release -DINTRINSIC_TRIANGULATIONS_BUILD_TESTS=OFF)
fi
cmake --build "$build" --target intrinsic --parallel "$(nproc)"

mkdir -p -- "$results"
name=$(basename -- "$mesh")
output=$results/${name%.*}
intrinsic=$build/bin/intrinsic

"$intrinsic" delaunay "$mesh" -o "$output.ply" --view "$output.html" \
  --stats "$output.delaunay.json"
"$intrinsic" laplacian "$mesh" -o "$output.laplacian.mtx"

cat -- "$output.delaunay.json"
echo
echo "Intrinsic Delaunay triangulation, drawn on the surface: $output.ply"
echo "The same, to look at in a browser:                      $output.html"
echo "Its statistics, shown above:                            $output.delaunay.json"
echo "Its Laplacian, MatrixMarket:                            $output.laplacian.mtx"
echo
echo "The program is $intrinsic. To call it by its name in this shell:"
echo "  export PATH=\"$build/bin:\$PATH\"; source <(intrinsic --completion bash)"
