#!/usr/bin/env bash
# Copyright (c) 2026 The Intrinsic Triangulations authors
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Installs what a wheel is built from in the images of cibuildwheel, which are of Enterprise Linux.
# Not tested: the wheel that the tests make is built on Debian.
set -euo pipefail
dnf install -y epel-release dnf-plugins-core
dnf config-manager --set-enabled powertools || dnf config-manager --set-enabled crb
dnf install -y CGAL-devel boost-devel cli11-devel eigen3-devel gmp-devel json-devel mpfr-devel \
  ninja-build npm patchelf pybind11-devel spectra-devel
# What pages are drawn by, which these systems do not package, where Debian has it.
three=/usr/share/javascript/three
mkdir -p "$three"
(cd "$three" && npm pack three@0.111.0 && tar --strip-components=1 -xzf three-0.111.0.tgz)
install -D -m 644 "$three/LICENSE" /usr/share/licenses/libjs-three/COPYING
