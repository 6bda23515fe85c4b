// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_IO_SUBDIVISION_SUBDIVISION_OUTPUT_H
#define CGAL_INTRINSIC_TRIANGULATIONS_IO_SUBDIVISION_SUBDIVISION_OUTPUT_H

#include <CGAL/Intrinsic_triangulations/IO/subdivision/Subdivision_field.h>
#include <CGAL/Intrinsic_triangulations/IO/support/columns.h>
#include <CGAL/Intrinsic_triangulations/correspondence/subdivision/Common_subdivision.h>

#include <cstdint>
#include <string>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// Numbers of elements are written as signed 32 bit integers, `none` as -1: modular by the
// standard; they are below 2^31.
inline std::int32_t signed_label(std::uint32_t i) { return static_cast<std::int32_t>(i); }

// The data of each vertex in files besides its position.
std::vector<Column> vertex_labels(const Common_subdivision& s);

// The names of the numbers of a field where each has its own: `v` or `v_x`, `v_y`, `v_z`.
std::vector<std::string> component_names(const Subdivision_field& field);

// Refuses fields and points that do not fit the subdivision.
void check_output(const Subdivision_output& o);

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_IO_SUBDIVISION_SUBDIVISION_OUTPUT_H
