// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DOWNSTREAM_CHECKS_H
#define DOWNSTREAM_CHECKS_H

// What the files of this program check, each in a translation unit of its own.

bool check_torus();      ///< exact flips
bool check_everything(); ///< all headers that need neither Eigen nor OpenMesh, together
bool check_operators();  ///< the headers that need Eigen
bool check_openmesh();   ///< the header that needs OpenMesh

#endif // DOWNSTREAM_CHECKS_H
