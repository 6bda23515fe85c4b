// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#define INTRINSIC_TRIANGULATIONS_TRIANGULATION_INSTANCE template
#include "triangulation_instances.h"
