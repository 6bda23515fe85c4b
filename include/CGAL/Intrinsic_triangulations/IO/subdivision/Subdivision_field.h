// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_IO_SUBDIVISION_SUBDIVISION_FIELD_H
#define CGAL_INTRINSIC_TRIANGULATIONS_IO_SUBDIVISION_SUBDIVISION_FIELD_H

#include <CGAL/Intrinsic_triangulations/correspondence/subdivision/Common_subdivision.h>

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/// Numbers or vectors in space at the vertices, faces or corners of a common subdivision, under a
/// name.
struct Subdivision_field {
  /// The elements with values.
  enum class Place : std::uint8_t {
    vertices, ///< each vertex
    faces,    ///< each face
    corners   ///< each corner of each face, in the order of `Common_subdivision::corner`
  };

  /// Letters, digits, underscores, dots and hyphens; not a name that files use themselves.
  std::string name;
  std::vector<double> values;    ///< `components` for each element
  Place place = Place::vertices; ///< what the values belong to
  unsigned components = 1;       ///< 1: numbers; 3: vectors in space
  /// Whether the numbers are whole ones that name classes, such as cells: pages give each class a
  /// colour of its own. Cells end where distances are equal if there is a field `distance`.
  bool has_classes = false;

  /// is a field without name or values.
  Subdivision_field() = default;
  /// takes a name and numbers.
  Subdivision_field(std::string its_name, std::vector<double> its_values,
                    Place its_place = Place::vertices)
      : name(std::move(its_name)), values(std::move(its_values)), place(its_place) {}
  /// takes a name and copies vectors.
  Subdivision_field(std::string its_name, std::span<const std::array<double, 3>> vectors,
                    Place its_place = Place::vertices)
      : name(std::move(its_name)), place(its_place), components(3) {
    for (const std::array<double, 3>& x : vectors) values.insert(values.end(), x.begin(), x.end());
  }
  /// takes a name and copies numbers. \tparam Range a range of numbers, such as `Eigen::VectorXd`
  template <class Range>
    requires(!std::is_convertible_v<const Range&, std::vector<double>> &&
             !std::is_convertible_v<const Range&, std::span<const std::array<double, 3>>>)
  Subdivision_field(std::string its_name, const Range& its_values,
                    Place its_place = Place::vertices)
      : name(std::move(its_name)), values(its_values.begin(), its_values.end()), place(its_place) {}

  /// returns whether it has a number per vertex.
  bool is_function() const { return place == Place::vertices && components == 1; }
};

namespace internal {

// The data to write.
struct Subdivision_output {
  const Common_subdivision& s;
  std::span<const std::array<double, 3>> points;
  std::span<const Subdivision_field> fields;
};

} // namespace internal

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_IO_SUBDIVISION_SUBDIVISION_FIELD_H
