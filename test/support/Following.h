// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef TEST_FOLLOWING_H
#define TEST_FOLLOWING_H

// A visitor that calls a function.
template <class Function>
struct Following {
  Function progress;
};
template <class Function>
Following(Function) -> Following<Function>;

#endif // TEST_FOLLOWING_H
