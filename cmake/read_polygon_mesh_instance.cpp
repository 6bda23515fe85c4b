// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#define INTRINSIC_TRIANGULATIONS_MESH_INSTANCE template
#include "read_polygon_mesh_instance.h"
