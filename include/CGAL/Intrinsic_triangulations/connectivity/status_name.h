// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_CONNECTIVITY_STATUS_NAME_H
#define CGAL_INTRINSIC_TRIANGULATIONS_CONNECTIVITY_STATUS_NAME_H

#include <CGAL/Intrinsic_triangulations/connectivity/Status.h>

namespace CGAL::Intrinsic_triangulations {

/// returns the word for how an algorithm ended, as in the documentation of `Status`.
inline const char* name_of(Status status) {
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

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_CONNECTIVITY_STATUS_NAME_H
