// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_IO_SOUP_SCAN_H
#define CGAL_INTRINSIC_TRIANGULATIONS_IO_SOUP_SCAN_H

#include <CGAL/Intrinsic_triangulations/domains/triangle_soup.h>

#include <cstdint>
#include <istream>

namespace CGAL::Intrinsic_triangulations::internal {

// Each scans a file of one format. `file_size` bounds the memory that a wrong count can claim.
void scan_GOCAD(std::istream& in, Soup_builder& out);
void scan_OBJ(std::istream& in, Soup_builder& out);
void scan_OFF(std::istream& in, std::uintmax_t file_size, Soup_builder& out);
void scan_PLY(std::istream& in, std::uintmax_t file_size, Soup_builder& out);
void scan_STL(std::istream& in, std::uintmax_t file_size, Soup_builder& out);
// Scans a list of points: three coordinates at the start of each line.
void scan_XYZ(std::istream& in, Soup_builder& out);

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_IO_SOUP_SCAN_H
