// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_DOMAINS_SORT_AROUND_EDGE_H
#define CGAL_INTRINSIC_TRIANGULATIONS_DOMAINS_SORT_AROUND_EDGE_H

#include <array>
#include <cstdint>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// Sorts points counterclockwise about the line from `a` to `b`, starting in the half plane of one of them; decided exactly.
// Points in one half plane keep their order, and so do those on the line, which come last.
// \param apices numbers of the points, from 0 in `points`
// \return places in `apices`, in the new order
// \pre coordinates are finite
std::vector<std::uint32_t> sort_around_edge(const std::vector<std::array<double, 3>>& points,
                                            std::uint32_t a, std::uint32_t b,
                                            const std::vector<std::uint32_t>& apices);

} // namespace CGAL::Intrinsic_triangulations::internal

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_COMPILED
#include <CGAL/Intrinsic_triangulations/domains/sort_around_edge_impl.h>
#endif

#endif // CGAL_INTRINSIC_TRIANGULATIONS_DOMAINS_SORT_AROUND_EDGE_H
