// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_SIMPLIFICATION_ISOMETRY_SEARCH_ISOMETRY_SEARCH_H
#define CGAL_INTRINSIC_SIMPLIFICATION_ISOMETRY_SEARCH_ISOMETRY_SEARCH_H

#include <CGAL/Intrinsic_simplification/isometry/Isometry_run.h>
#include <CGAL/Intrinsic_simplification/isometry/find_isometries.h>
#include <CGAL/Intrinsic_simplification/isometry/search/Dart_matching.h>
#include <CGAL/Intrinsic_simplification/isometry/search/Length_classes.h>
#include <CGAL/Intrinsic_simplification/isometry/tessellation/Dart_complex.h>
#include <CGAL/Intrinsic_simplification/isometry/tessellation/Singular_surface.h>
#include <CGAL/Intrinsic_triangulations/triangulation/Surface_point.h>

#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// Searches the isometries between two surfaces, first exactly, then up to
// rounding.
class Isometry_search {
public:
  using Surface = std::shared_ptr<const Singular_surface>;

  Isometry_search(Surface a, Surface b, Isometry_run& run);

  Isometry_answer answer() const { return answer_; }
  const std::string& note() const { return note_; }
  double largest_difference() const { return largest_difference_; }
  double count() const;
  std::size_t number_of_walks() const { return number_of_walks_; }

  // Fills the maps of isometry number `n`.
  void compute(std::size_t n, Isometry& result) const;
  std::vector<Surface_point> images(const Isometry& map,
                                    std::span<const Surface_point> points) const;
  static Isometry isometry(const std::shared_ptr<const Isometry_search>& search, std::size_t n) {
    return Isometry(search, n);
  }

private:
  // Edges that separate no polygons, and the polygons.
  struct Tessellation {
    std::vector<char> ties;
    Dart_complex darts;
  };

  void search(Isometry_run& run);
  void take_all_vertices(Isometry_run& run);
  void decide_exactly(Isometry_run& run);
  bool decide_within(double error, Isometry_run& run);
  void match(const Length_classes& classes);
  Isometry own(std::size_t n) const; // does not keep this object
  // whether fans of faces that meet at a vertex go to fans that meet at one
  bool respects_vertices(const Isometry& map) const;
  // Finds maps that respect vertices: all of them, if few are to be tried. \return whether one is
  // found
  bool find_maps();
  double number_of_maps_of_fans() const;
  double difference_of(const Isometry& map) const;
  // The image of the dart `first.dart` of a component of a group: back to the
  // first dart of the group, by the symmetry, and on to the component of
  // `second`. `image` is memory.
  Directed_dart composed(const Dart_matching::Group& g, const Directed_dart& first,
                         const Directed_dart& second, const Directed_dart& symmetry,
                         std::vector<std::uint32_t>& image) const;
  std::vector<Plane_face> polygon(const Singular_surface& s, const Tessellation& t,
                                  std::uint32_t halfedge) const;
  Surface_point image(const Isometry& map, const Surface_point& p) const;

  Surface a_, b_;
  std::optional<Tessellation> first_,
      second_; // the second one only if surfaces differ
  std::optional<Dart_matching> matching_;
  // Isometries that respect vertices, in the order of digits: all, if `are_all_found_`, or the
  // first one, which is number 0. Empty: all do.
  std::vector<std::size_t> maps_;
  bool are_all_found_ = true;
  Isometry_answer answer_ = Isometry_answer::undecided;
  std::string note_;
  double largest_difference_ = std::numeric_limits<double>::infinity();
  std::size_t number_of_walks_ = 0;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_SIMPLIFICATION_ISOMETRY_SEARCH_ISOMETRY_SEARCH_H
