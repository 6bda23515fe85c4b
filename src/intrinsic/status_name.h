// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_STATUS_NAME_H
#define INTRINSIC_STATUS_NAME_H

#include <CGAL/Intrinsic_triangulations/connectivity/Status.h>

namespace program {

/// returns the word for how an algorithm ended, as in its documentation.
inline const char* name(CGAL::Intrinsic_triangulations::Status status) {
  using CGAL::Intrinsic_triangulations::Status;
  switch (status) {
  case Status::done:
    return "done";
  case Status::stopped:
    return "stopped";
  case Status::contracted:
    return "contracted";
  case Status::cap:
    return "cap";
  case Status::stalled:
    return "stalled";
  case Status::cancelled:
    return "cancelled";
  case Status::inaccurate:
    return "inaccurate";
  case Status::border:
    return "border";
  case Status::not_traceable:
    return "not_traceable";
  }
  return "";
}

} // namespace program

#endif // INTRINSIC_STATUS_NAME_H
