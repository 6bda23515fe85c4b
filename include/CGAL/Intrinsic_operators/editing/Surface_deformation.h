// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_OPERATORS_EDITING_SURFACE_DEFORMATION_H
#define CGAL_INTRINSIC_OPERATORS_EDITING_SURFACE_DEFORMATION_H

#include <CGAL/Intrinsic_operators/editing/Biharmonic_interpolation.h>
#include <CGAL/Intrinsic_operators/operators/cotangent_laplacian.h>
#include <CGAL/Intrinsic_operators/operators/mass_matrix.h>
#include <CGAL/Intrinsic_operators/solvers/Fixed_values_solver.h>
#include <CGAL/Intrinsic_operators/solvers/matrix_rows.h>
#include <CGAL/Intrinsic_triangulations/compilation.h>
#include <CGAL/Intrinsic_triangulations/triangulation/concepts.h>

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/// What a deformation makes least.
enum class Deformation_energy {
  harmonic, ///< the integral of |grad d|^2: displacements stay within their range, and have cusps at single handles
  biharmonic ///< the integral of (Laplacian d)^2: smooth at handles too
};

/*!
\brief deforms a surface by moving some of its vertices, the handles: others follow such that the displacement d is as smooth as can be
(Botsch and Sorkine 2008; Fig. 41 of the course).

    L d = 0   or   L M^-1 L d = 0    at free vertices,    d given at handles

with the cotangent Laplacian L and the lumped mass M. The operator is that of the surface before it is deformed, and is factored once:
handles may then be moved many times. On a Delaunay triangulation L has no negative weights, on a cover it is that of the user's surface; either is
what slivers and nonmanifold meshes need. A displacement is of any dimension, data of any kind.

Where there is no handle in a component, and at isolated vertices, nothing moves. Rows are those of vertices, `t.input_vertex(v)`, inserted
ones included; those of the user's mesh come first.
*/
class Surface_deformation {
public:
  /*!
  \brief factors the operator.
  \tparam Triangulation a model of `MeasuredTriangulation`
  \param t the triangulation, of which nothing is kept
  \param handles rows of the handles, repeated or not
  \param energy what is made least
  \throws Invalid_input if a face has no area
  \throws std::invalid_argument if a row does not exist
  \throws Indefinite_matrix if rounding has left no definite matrix. With up to some tens of handles beside free vertices that needs two handles at no
    distance: the biharmonic problem is solved by two harmonic ones then, which slivers do not harm, see `Laplacian_factorization`
  \complexity that of a sparse factorization, and of a solution per handle beside free vertices if they are few
  */
  template <MeasuredTriangulation Triangulation>
  Surface_deformation(const Triangulation& t, std::span<const std::uint32_t> handles,
                      Deformation_energy energy = Deformation_energy::biharmonic)
      : Surface_deformation(cotangent_laplacian(t), lumped_mass_matrix(t).diagonal(), handles,
                            energy) {}

  /*!
  \brief factors the operator that two matrices make.
  \param laplacian the matrix L, positive semidefinite
  \param mass the diagonal of the matrix M, positive but at isolated vertices; only the biharmonic energy reads it
  */
  Surface_deformation(const Eigen::SparseMatrix<double>& laplacian, const Eigen::VectorXd& mass,
                      std::span<const std::uint32_t> handles, Deformation_energy energy);

  /*!
  \brief moves the handles.
  \param displacements a row per handle as they were given, and a column per coordinate
  \return the displacements of all vertices
  \throws std::invalid_argument if there is not a row per handle, a number is not finite, or a handle that was given twice has two displacements
  \complexity linear in the entries of the factor, for each column
  */
  Eigen::MatrixXd displacements(const Eigen::MatrixXd& displacements) const;

private:
  void factor_biharmonic(const Eigen::SparseMatrix<double>& laplacian, const Eigen::VectorXd& mass);

  std::vector<std::uint32_t> rows_; // handles, and what stays
  std::size_t handles_;
  Eigen::Index size_;
  std::optional<Fixed_values_solver> solver_; // of a matrix, or
  std::optional<internal::Biharmonic_interpolation> by_handles_;
};

} // namespace CGAL::Intrinsic_triangulations

#if CGAL_INTRINSIC_TRIANGULATIONS_DEFINES(FUNCTIONS)
namespace CGAL::Intrinsic_triangulations {

namespace internal {

// L M^-1 L; isolated vertices, which have no mass, are fixed
inline Eigen::SparseMatrix<double> bilaplacian(const Eigen::SparseMatrix<double>& l,
                                               const Eigen::VectorXd& mass) {
  Eigen::VectorXd inverse(mass.size());
  for (Eigen::Index i = 0; i < mass.size(); ++i) inverse[i] = mass[i] > 0 ? 1 / mass[i] : 0;
  return l * inverse.asDiagonal() * l;
}

// whether rows that are not handles, and have neighbours, have masses
inline bool all_free_have_mass(const Eigen::SparseMatrix<double>& laplacian,
                               const Eigen::VectorXd& mass,
                               std::span<const std::uint32_t> handles) {
  std::vector<char> needs_none(static_cast<std::size_t>(mass.size()), 0);
  for (const std::uint32_t r : handles) needs_none[r] = 1;
  for (Eigen::Index r = 0; r < mass.size(); ++r)
    if (mass[r] == 0 && needs_none[static_cast<std::size_t>(r)] == 0 &&
        laplacian.outerIndexPtr()[r + 1] - laplacian.outerIndexPtr()[r] > 1)
      return false;
  return true;
}

} // namespace internal

CGAL_INTRINSIC_TRIANGULATIONS_INLINE
Surface_deformation::Surface_deformation(const Eigen::SparseMatrix<double>& laplacian,
                                         const Eigen::VectorXd& mass,
                                         std::span<const std::uint32_t> handles,
                                         Deformation_energy energy)
    : rows_(handles.begin(), handles.end()), handles_(handles.size()), size_(laplacian.rows()) {
  if (mass.size() != size_)
    throw std::invalid_argument("there must be a mass per row of the Laplacian");
  if (!mass.allFinite() || !(mass.array() >= 0).all())
    throw std::invalid_argument("masses must be finite and not negative");
  std::vector<char> is_handle(static_cast<std::size_t>(size_), 0);
  for (const std::uint32_t r : handles) {
    if (r >= is_handle.size())
      throw std::invalid_argument("row " + std::to_string(r) + " is a handle, but there are " +
                                  std::to_string(size_) + " rows");
    is_handle[r] = 1;
  }
  const std::vector<std::uint32_t> component = components_of_matrix(laplacian);
  std::vector<char> has_handle(is_handle.size(), 0);
  for (const std::uint32_t r : handles) has_handle[component[r]] = 1;
  for (std::uint32_t r = 0; r < is_handle.size(); ++r) // isolated ones are components
    if (component[r] == r && has_handle[r] == 0) rows_.push_back(r);
  if (energy == Deformation_energy::harmonic)
    solver_.emplace(laplacian, rows_);
  else
    factor_biharmonic(laplacian, mass);
}

// By handles where that is faster; where the matrix is not definite, if memory allows.
CGAL_INTRINSIC_TRIANGULATIONS_INLINE void
Surface_deformation::factor_biharmonic(const Eigen::SparseMatrix<double>& laplacian,
                                       const Eigen::VectorXd& mass) {
  constexpr std::size_t few = 64, many = 2000, numbers = 100000000;
  std::vector<std::uint32_t> beside = internal::rows_beside_free_ones(laplacian, rows_);
  // rows without mass, which the product leaves out, would have to be harmonic
  const bool is_laplacian =
      internal::is_laplacian(laplacian) && internal::all_free_have_mass(laplacian, mass, rows_);
  const auto by_handles = [&] { // the unit of masses is that of the energy alone
    const double greatest = size_ > 0 ? mass.maxCoeff() : 0;
    const double unit = greatest > 0 ? std::ldexp(1., -std::ilogb(greatest)) : 1;
    by_handles_.emplace(laplacian, unit * mass, rows_, std::move(beside));
  };
  if (is_laplacian && beside.size() <= few) return by_handles();
  try {
    solver_.emplace(internal::bilaplacian(laplacian, mass), rows_);
  } catch (const Indefinite_matrix& error) {
    if (!is_laplacian || beside.size() > many ||
        beside.size() > numbers / static_cast<std::size_t>(size_))
      throw Indefinite_matrix(error.row(), "faces there are too different in size for so many "
                                           "handles; give fewer, or take the harmonic energy");
    by_handles();
  }
}

CGAL_INTRINSIC_TRIANGULATIONS_INLINE Eigen::MatrixXd
Surface_deformation::displacements(const Eigen::MatrixXd& displacements) const {
  if (displacements.rows() != static_cast<Eigen::Index>(handles_))
    throw std::invalid_argument(
        "there must be a displacement per handle: " + std::to_string(handles_) + ", not " +
        std::to_string(displacements.rows()));
  Eigen::MatrixXd values =
      Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(rows_.size()), displacements.cols());
  values.topRows(displacements.rows()) = displacements;
  if (by_handles_) return by_handles_->solve(values);
  return solver_->solve(Eigen::MatrixXd::Zero(size_, displacements.cols()), values);
}

} // namespace CGAL::Intrinsic_triangulations
#endif

#endif // CGAL_INTRINSIC_OPERATORS_EDITING_SURFACE_DEFORMATION_H
