// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

// The meshes of most tests.

#include "gallery_impl.h"
#include "meshes_impl.h"
