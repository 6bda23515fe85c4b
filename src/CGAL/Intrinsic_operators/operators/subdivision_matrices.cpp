// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_operators/operators/subdivision_matrices.h>
#include <CGAL/Intrinsic_operators/operators/symmetric_assembly.h>
#include <CGAL/Intrinsic_triangulations/IO/subdivision/Subdivision_field.h>
#include <CGAL/Intrinsic_triangulations/correspondence/subdivision/Common_subdivision.h>

#include <Eigen/Core>

#include <cstddef>
#include <cstdint>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>

namespace CGAL::Intrinsic_triangulations {

namespace internal {

// entries of one row; sorted, and equal columns added up
static void append_row(Weighted_vertices w, Interpolation_matrix& m, Eigen::Index row) {
  m.startVec(row);
  for (const std::size_t i : {1U, 2U, 1U})
    if (i < w.size && w.vertices[i] < w.vertices[i - 1]) {
      std::swap(w.vertices[i], w.vertices[i - 1]);
      std::swap(w.weights[i], w.weights[i - 1]);
    }
  for (std::size_t i = 0; i < w.size;) {
    const std::uint32_t column = w.vertices[i];
    double sum = 0;
    for (; i < w.size && w.vertices[i] == column; ++i) sum += w.weights[i];
    if (sum != 0) m.insertBackByOuterInner(row, column) = sum;
  }
}

// `locate(v)` returns the location of vertex `v` of the subdivision
template <class Locate>
static Interpolation_matrix interpolation_matrix(const Common_subdivision& s, std::uint32_t columns,
                                                 const Locate& locate) {
  const std::size_t rows = s.number_of_vertices();
  expect_countable(3 * rows, "the common subdivision has " + std::to_string(rows) + " vertices");
  Interpolation_matrix m(static_cast<Eigen::Index>(rows), columns);
  m.reserve(static_cast<Eigen::Index>(s.vertices.size() + 2 * s.crossings.size()));
  for (std::size_t v = 0; v < rows; ++v) append_row(locate(v), m, static_cast<Eigen::Index>(v));
  m.finalize();
  return m;
}

} // namespace internal

Interpolation_matrix interpolation_from_input(const Common_subdivision& s) {
  return internal::interpolation_matrix(s, s.number_of_input_vertices,
                                        [&s](std::size_t v) { return s.on_input(v); });
}

Interpolation_matrix interpolation_from_intrinsic(const Common_subdivision& s) {
  return internal::interpolation_matrix(s, s.number_of_intrinsic_vertices,
                                        [&s](std::size_t v) { return s.on_intrinsic(v); });
}

Eigen::VectorXd nearest_values(const Interpolation_matrix& interpolation,
                               const Eigen::VectorXd& values) {
  Eigen::VectorXd result =
      Eigen::VectorXd::Constant(interpolation.rows(), std::numeric_limits<double>::quiet_NaN());
  for (Eigen::Index i = 0; i < interpolation.rows(); ++i) {
    double most = 0;
    for (Interpolation_matrix::InnerIterator x(interpolation, i); x; ++x)
      if (x.value() > most) {
        most = x.value();
        result[i] = values[x.col()];
      }
  }
  return result;
}

Subdivision_field interpolated_field(std::string name, const Interpolation_matrix& interpolation,
                                     const Eigen::VectorXd& values, bool has_classes) {
  const Eigen::VectorXd known = values.head(interpolation.cols());
  Subdivision_field field(std::move(name), has_classes ? nearest_values(interpolation, known)
                                                       : Eigen::VectorXd(interpolation * known));
  field.has_classes = has_classes;
  return field;
}

Subdivision_field interpolated_field(std::string name, const Common_subdivision& s,
                                     const Eigen::VectorXd& values, bool has_classes) {
  const bool is_intrinsic = values.size() == s.number_of_intrinsic_vertices;
  if (!is_intrinsic && values.size() != s.number_of_input_vertices)
    throw std::invalid_argument(
        name + " has " + std::to_string(values.size()) + " numbers; give one for each of " +
        std::to_string(s.number_of_intrinsic_vertices) + " vertices of the triangulation, or " +
        std::to_string(s.number_of_input_vertices) + " of the mesh");
  return interpolated_field(
      std::move(name), is_intrinsic ? interpolation_from_intrinsic(s) : interpolation_from_input(s),
      values, has_classes);
}

} // namespace CGAL::Intrinsic_triangulations
