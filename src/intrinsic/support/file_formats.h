// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_SUPPORT_FILE_FORMATS_H
#define INTRINSIC_SUPPORT_FILE_FORMATS_H

#include <string>
#include <vector>

namespace program {

/// Contents of files that the program reads or writes; one table has their names and extensions.
enum class Contents {
  mesh,
  point_set,
  triangulation,
  subdivision,
  curves,
  points,
  values,
  valued_subdivision,
  matrix,
  full_matrix,
  cut_surface,
  coarse_surface,
  polyhedron
};

/// returns whether files with the extension of a path may have such contents.
bool is_file_of(Contents contents, const std::string& path);
/// returns the extensions of files with such contents: ".vtp, .obj or .ply".
std::string extensions_of(Contents contents);
/// returns the first of them, with its dot.
std::string first_extension_of(Contents contents);
/// returns the extensions of all files that can be an input, without dots.
std::vector<std::string> input_formats();
/// returns several contents with their extensions: "values to .txt or curves to .obj or .vtp".
std::string listed_with_extensions(const std::vector<Contents>& contents);

} // namespace program

#endif // INTRINSIC_SUPPORT_FILE_FORMATS_H
