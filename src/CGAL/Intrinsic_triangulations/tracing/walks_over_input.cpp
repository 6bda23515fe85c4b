// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_triangulations/input/Input.h>
#include <CGAL/Intrinsic_triangulations/tracing/geodesic_face.h>
#include <CGAL/Intrinsic_triangulations/tracing/geodesic_to_target.h>
#include <CGAL/Intrinsic_triangulations/tracing/geodesic_walk.h>
#include <CGAL/Intrinsic_triangulations/tracing/trace_geodesic.h>

#include <cstddef>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

template bool turn(const Input&, Corner_direction&, double);

namespace internal {

template Geodesic_end finish_walk(const Input&, Geodesic_walk<Input>, double, const Trace_options&,
                                  std::vector<Geodesic_crossing>&);
template Geodesic_to_target trace_to_target(const Input&, const Geodesic_walk<Input>&,
                                            const Geodesic_target&, double,
                                            std::vector<Strip_side>&, std::size_t);

} // namespace internal

} // namespace CGAL::Intrinsic_triangulations
