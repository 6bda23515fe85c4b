#!/usr/bin/env bash
# Copyright (c) 2026 The Intrinsic Triangulations authors
# SPDX-License-Identifier: GPL-3.0-or-later
#
# usage: test/run.sh [CTEST_OPTION...]
# From a bare Debian 12 to a tested build: installs what is missing, builds everything in
# build/release, runs all tests. `.ci/run` also checks that every header compiles alone.
set -euo pipefail

root=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")/.." && pwd)

bash "$root/cmake/install_dependencies.sh" \
  g++ cmake ninja-build libcgal-dev libcgal-demo libgmp-dev libmpfr-dev libboost-dev \
  libeigen3-dev libspectra-dev libopenmesh-dev libcli11-dev nlohmann-json3-dev libjs-three libgtest-dev doxygen \
  libjs-mathjax doxygen-awesome-css python3 python3-matplotlib python3-pandas \
  pybind11-dev python3-dev python3-numpy python3-scipy python3-hypothesis

cd -- "$root"
cmake --preset release \
  -DINTRINSIC_TRIANGULATIONS_BUILD_TESTS=ON -DINTRINSIC_TRIANGULATIONS_BUILD_EXAMPLES=ON \
  -DINTRINSIC_TRIANGULATIONS_BUILD_PYTHON=ON
cmake --build --preset release --parallel "$(nproc)"
ctest --preset release --output-on-failure --parallel "$(nproc)" "$@"
