// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

// What reads and prepares inputs; what refinement keeps of them.

#define CGAL_INTRINSIC_TRIANGULATIONS_IN_INPUT 1

#include <CGAL/Intrinsic_triangulations/connectivity/build_gluing_impl.h>
#include <CGAL/Intrinsic_triangulations/domains/Domain_impl.h>
#include <CGAL/Intrinsic_triangulations/domains/Point_cloud.h>
#include <CGAL/Intrinsic_triangulations/input/Intrinsic_input_impl.h>
#include <CGAL/Intrinsic_triangulations/input/Polygon_flattener_impl.h>
#include <CGAL/Intrinsic_triangulations/input/Polygon_shaper_impl.h>

#include <array>
#include <cstdint>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

template Gluing internal::unglued_triangles(std::uint32_t,
                                            const std::vector<std::array<std::uint32_t, 3>>&);

} // namespace CGAL::Intrinsic_triangulations
