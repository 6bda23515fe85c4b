// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "file_formats.h"

#include <CGAL/Intrinsic_geodesics/cuts/write_cut_surface.h>
#include <CGAL/Intrinsic_triangulations/IO/curves/write_polylines.h>
#include <CGAL/Intrinsic_triangulations/IO/soup/read_triangle_soup.h>
#include <CGAL/Intrinsic_triangulations/IO/subdivision/write_common_subdivision.h>

#include <array>
#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace program {
namespace {

namespace IT = CGAL::Intrinsic_triangulations;

struct Format {
  std::string_view words;
  std::span<const std::string_view> extensions; // without the dot
};

constexpr std::array<std::string_view, 1> triangulation{"idt"};
constexpr std::array<std::string_view, 1> values{"txt"};
constexpr std::array<std::string_view, 2> with_values{"ply", "vtp"};
constexpr std::array<std::string_view, 1> matrix{"mtx"};
constexpr std::array<std::string_view, 2> full_matrix{"npy", "txt"};
constexpr std::array<std::string_view, 2> polyhedron{"off", "obj"};

// in the order of `Contents`
constexpr std::array<Format, 13> formats{
    {{"meshes", IT::mesh_extensions},
     {"lists of points", IT::point_set_extensions},
     {"the intrinsic triangulation", triangulation},
     {"the common subdivision", IT::common_subdivision_extensions},
     {"curves", IT::polyline_extensions},
     {"points", IT::polyline_extensions},
     {"values", values},
     {"the common subdivision with values", with_values},
     {"matrices in Matrix Market format", matrix},
     {"a matrix", full_matrix},
     {"the surface cut open", IT::cut_surface_extensions},
     {"the coarse triangles in space", IT::common_subdivision_extensions},
     {"the polyhedron", polyhedron}}};

const Format& format(Contents contents) { return formats[static_cast<std::size_t>(contents)]; }

// "a, b or c"
std::string listed(const std::vector<std::string>& words) {
  std::string text;
  for (std::size_t i = 0; i < words.size(); ++i)
    text += (i == 0 ? "" : i + 1 == words.size() ? " or " : ", ") + words[i];
  return text;
}

} // namespace

bool is_file_of(Contents contents, const std::string& path) {
  return IT::has_extension(path, format(contents).extensions);
}

std::string extensions_of(Contents contents) {
  std::vector<std::string> words;
  for (const std::string_view extension : format(contents).extensions)
    words.emplace_back(".").append(extension);
  return listed(words);
}

std::string first_extension_of(Contents contents) {
  return std::string(".").append(format(contents).extensions.front());
}

std::vector<std::string> input_formats() {
  std::vector<std::string> words;
  for (const Contents c : {Contents::mesh, Contents::point_set, Contents::triangulation})
    for (const std::string_view extension : format(c).extensions) words.emplace_back(extension);
  return words;
}

std::string listed_with_extensions(const std::vector<Contents>& contents) {
  std::vector<std::string> words;
  for (const Contents c : contents)
    words.push_back(std::string(format(c).words) + " to " + extensions_of(c));
  return listed(words);
}

} // namespace program
