// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_OPERATORS_EDITING_SURFACE_DEFORMATION_IMPL_H
#define CGAL_INTRINSIC_OPERATORS_EDITING_SURFACE_DEFORMATION_IMPL_H

#include <CGAL/Intrinsic_operators/editing/Surface_deformation.h>
#include <CGAL/Intrinsic_operators/solvers/components_of_matrix.h>
#include <CGAL/Intrinsic_triangulations/compilation.h>

#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>

namespace CGAL::Intrinsic_triangulations {

namespace internal {

// L M^-1 L; isolated vertices, which have no mass, are fixed
inline Eigen::SparseMatrix<double> bilaplacian(const Eigen::SparseMatrix<double>& l,
                                               const Eigen::VectorXd& mass) {
  Eigen::VectorXd inverse(mass.size());
  for (Eigen::Index i = 0; i < mass.size(); ++i) inverse[i] = mass[i] > 0 ? 1 / mass[i] : 0;
  return l * inverse.asDiagonal() * l;
}

} // namespace internal

namespace internal {

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

#endif // CGAL_INTRINSIC_OPERATORS_EDITING_SURFACE_DEFORMATION_IMPL_H
