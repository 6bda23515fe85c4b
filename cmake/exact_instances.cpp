// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#define INTRINSIC_TRIANGULATIONS_INSTANCE template
#include "exact_instances.h"
