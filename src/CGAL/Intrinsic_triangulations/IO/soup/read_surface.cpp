// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_triangulations/IO/soup/read_surface.h>
#include <CGAL/Intrinsic_triangulations/IO/soup/read_triangle_soup.h>
#include <CGAL/Intrinsic_triangulations/support/Invalid_input.h>
#include <CGAL/Intrinsic_triangulations/support/Stopwatch.h>
#include <CGAL/Intrinsic_triangulations/support/defaults.h>

#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <utility>

namespace CGAL::Intrinsic_triangulations {

namespace internal {

// What a word names.
template <class Value, std::size_t n>
static Value value_of_word(const std::string& option, const std::string& word,
                           const std::array<std::pair<std::string_view, Value>, n>& values) {
  std::string words;
  for (const auto& [name, value] : values) {
    if (name == word) return value;
    words.append(words.empty() ? "" : ", ").append(name);
  }
  throw Invalid_input(Element_kind::none, 0,
                      "--" + option + " cannot be \"" + word + "\"; give one of " + words);
}

} // namespace internal

Surface_options surface_options(const std::string& domain, const std::string& mollification,
                                const std::string& polygons) {
  constexpr std::array<std::pair<std::string_view, Domain_kind>, 6> kinds{
      {{"auto", Domain_kind::automatic},
       {"manifold", Domain_kind::manifold},
       {"orientation-cover", Domain_kind::orientation_cover},
       {"tufted", Domain_kind::tufted_cover},
       {"closed", Domain_kind::closed},
       {"points", Domain_kind::automatic}}};
  constexpr std::array<std::pair<std::string_view, Mollification>, 4> mollifications{
      {{"automatic", Mollification::automatic},
       {"none", Mollification::none},
       {"lengths", Mollification::lengths},
       {"squared", Mollification::squared_lengths}}};
  constexpr std::array<std::pair<std::string_view, Nonplanar_polygons>, 2> treatments{
      {{"fan", Nonplanar_polygons::fan}, {"planar", Nonplanar_polygons::planar}}};
  Surface_options o;
  o.kind = internal::value_of_word("domain", domain, kinds);
  o.is_points = domain == "points";
  o.mollification = internal::value_of_word("mollification", mollification, mollifications);
  o.polygons = internal::value_of_word("polygons", polygons, treatments);
  return o;
}

Read_surface make_surface(Triangle_soup soup, const Surface_options& options) {
  Read_surface made;
  Surface_facts& facts = made.facts;
  if (soup.triangles.empty()) {
    Point_cloud cloud = make_point_cloud(
        soup.points, options.neighbors.value_or(defaults::neighbors), options.mollification);
    made.input = std::move(cloud.input);
    facts.domain = std::move(cloud.report);
    facts.cloud = std::move(cloud.points);
    return made;
  }
  if (options.neighbors)
    throw Invalid_input(Element_kind::none, 0,
                        "--neighbors is for files without faces, and this file has faces; leave it "
                        "out, or ignore faces with --domain points");
  facts.polygons = soup.input_faces;
  facts.triangulated_polygons = soup.triangulated_polygons;
  facts.faces_with_repeated_vertices = soup.faces_with_repeated_vertices;
  facts.planar_polygons = soup.planar_polygons.report;
  Domain domain = make_domain(std::move(soup), options.kind, options.mollification);
  made.input = std::move(domain.input);
  facts.domain = std::move(domain.report);
  return made;
}

Read_surface read_surface(const std::string& path, const Surface_options& options) {
  const File_faces faces = options.is_points                        ? File_faces::ignored
                           : options.kind == Domain_kind::automatic ? File_faces::optional
                                                                    : File_faces::needed;
  Stopwatch watch;
  Triangle_soup soup = read_triangle_soup(path, options.polygons, faces);
  const double seconds = watch.lap();
  try {
    Read_surface made = make_surface(std::move(soup), options);
    made.facts.seconds_of_reading = seconds;
    return made;
  } catch (const Invalid_input& e) {
    throw Invalid_input(e.kind(), e.index(), path + ": " + e.what());
  }
}

} // namespace CGAL::Intrinsic_triangulations
