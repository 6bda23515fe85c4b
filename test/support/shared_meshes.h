// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef TEST_INTRINSIC_TRIANGULATIONS_SHARED_MESHES_H
#define TEST_INTRINSIC_TRIANGULATIONS_SHARED_MESHES_H

// Meshes of tests are in headers `*_impl.h`, which other headers include. Or they are compiled once, `shared_meshes.cpp`, and
// `TEST_MESHES_COMPILED` is defined.

#ifdef TEST_MESHES_COMPILED
#define TEST_MESHES_INLINE
#else
#define TEST_MESHES_INLINE inline
#endif

#endif // TEST_INTRINSIC_TRIANGULATIONS_SHARED_MESHES_H
