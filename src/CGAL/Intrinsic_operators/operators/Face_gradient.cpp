// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_operators/operators/Face_gradient.h>
#include <CGAL/Intrinsic_operators/operators/Face_table.h>
#include <CGAL/Intrinsic_operators/solvers/matrix_rows.h>
#include <CGAL/Intrinsic_triangulations/support/cmath.h>

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <complex>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

namespace internal {

static Eigen::Index face_row(std::size_t f) { return static_cast<Eigen::Index>(f); }
static void expect_size(Eigen::Index size, Eigen::Index asked, const char* what, const char* per) {
  if (size != asked)
    throw std::invalid_argument(std::string("the ") + what + " must have a value per " + per +
                                ": " + std::to_string(asked) + ", not " + std::to_string(size));
}

} // namespace internal

Face_gradient::Vectors Face_gradient::gradient(const Function& u) const {
  internal::expect_size(u.size(), vertices_, "function", "vertex");
  Vectors result(number_of_faces());
  for (std::size_t f = 0; f < faces_.size(); ++f) {
    const Face& face = faces_[f];
    result[internal::face_row(f)] = 0;
    if (face.area == 0) continue; // no face
    // differences: constants give exactly zero
    const double base = u[face.row[0]];
    result[internal::face_row(f)] = (u[face.row[1]] - base) * face.hat_gradient[1] +
                                    (u[face.row[2]] - base) * face.hat_gradient[2];
  }
  return result;
}

Face_gradient::Function Face_gradient::divergence(const Vectors& x) const {
  internal::expect_size(x.size(), number_of_faces(), "field", "number of a face");
  Function result = Function::Zero(vertices_);
  for (std::size_t f = 0; f < faces_.size(); ++f) {
    const Face& face = faces_[f];
    if (face.area == 0) continue;
    for (std::size_t k = 0; k < 3; ++k)
      result[face.row[k]] -= face.area / sheets_ *
                             std::real(std::conj(face.hat_gradient[k]) * x[internal::face_row(f)]);
  }
  return result;
}

Face_gradient::Function Face_gradient::curl(const Vectors& x) const {
  return divergence(Vector(0, -1) * x);
}

Eigen::SparseMatrix<Face_gradient::Vector> Face_gradient::matrix() const {
  std::vector<Eigen::Triplet<Vector>> entries;
  entries.reserve(3 * faces_.size());
  for (std::size_t f = 0; f < faces_.size(); ++f)
    for (std::size_t k = 0; k < 3; ++k)
      if (faces_[f].area > 0)
        entries.emplace_back(static_cast<int>(f), faces_[f].row[k], faces_[f].hat_gradient[k]);
  return internal::matrix_of(number_of_faces(), vertices_, entries);
}

bool Face_gradient::measure(const internal::Face_table& table, std::uint32_t f) {
  const internal::Table_face& read = table.faces[table.slot[f]];
  const auto corners = read.layout();
  Face& face = faces_[f];
  face.row = read.rows;
  face.area = table.unscaled(table.unscaled(read.area()));
  double sum = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const Vector side = (corners[(k + 2) % 3] - corners[(k + 1) % 3]) / (read.quadruple_area / 2);
    face.hat_gradient[k] = {std::ldexp(-side.imag(), table.scale_exponent),
                            std::ldexp(side.real(), table.scale_exponent)};
    sum += std::norm(face.hat_gradient[k]);
  }
  return std::isfinite(sum);
}

} // namespace CGAL::Intrinsic_triangulations
