// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_OPERATORS_EDITING_SURFACE_DEFORMATION_H
#define CGAL_INTRINSIC_OPERATORS_EDITING_SURFACE_DEFORMATION_H

#include <CGAL/Intrinsic_operators/operators/cotangent_laplacian.h>
#include <CGAL/Intrinsic_operators/operators/mass_matrix.h>
#include <CGAL/Intrinsic_operators/solvers/Fixed_values_solver.h>
#include <CGAL/Intrinsic_operators/solvers/Linear_solver.h>
#include <CGAL/Intrinsic_triangulations/support/Status.h>
#include <CGAL/Intrinsic_triangulations/support/parameters.h>
#include <CGAL/Intrinsic_triangulations/triangulation/concepts.h>

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/// The energy that a deformation minimizes.
enum class Deformation_energy {
  /// the integral of |grad d|^2: displacements stay within their range; cusps at single handles
  harmonic,
  biharmonic ///< the integral of (Laplacian d)^2: smooth at handles too
};

/// A long step before a deformation.
enum class Deformation_step {
  matrices, ///< the matrices are assembled
  factored  ///< the operator is factored
};

namespace internal {
class Biharmonic_interpolation;
} // namespace internal

/*!
\brief deforms a surface by moving some vertices, the handles. The displacement d of the others is
as smooth as possible (Botsch and Sorkine 2008; Fig. 41 of the course).

    L d = 0   or   L M^-1 L d = 0    at free vertices,    d given at handles

with the cotangent Laplacian L and the lumped mass M. The operator of the undeformed surface is
factored once; then handles may move many times. On a Delaunay triangulation L has no negative
weights, which slivers need; on a cover L is that of the user's surface, which nonmanifold meshes
need. Displacements may have any dimension.

Components without a handle and isolated vertices do not move. Rows are those of vertices,
`t.input_vertex(v)`, inserted ones included; those of the user's mesh come first.
*/
class Surface_deformation {
public:
  /*!
  \brief factors the operator.
  \tparam Triangulation a model of `MeasuredTriangulation`
  \tparam NP a chain of named parameters
  \param t the triangulation; no reference to it is kept
  \param handles rows of the handles, repeated or not
  \param energy the energy to minimize
  \param solver how to solve, for any number of displacements. Harmonic problems can be iterated;
    the square of the Laplacian, which many handles of the biharmonic energy need, is factored
  \param np optional named parameters:
    - `visitor(v)`: `v.progress(step)` is called with a `Deformation_step` after each, and returns
      whether to go on. If not, the `status()` is `cancelled`, and nothing can be deformed.
  \throws Invalid_input if a face has no area
  \throws std::invalid_argument if a row does not exist; or if you asked for an iteration, and the
    square of the Laplacian is needed
  \throws Indefinite_matrix if rounding makes the matrix indefinite. If few handles (some tens) have
  free neighbours, this needs two handles at distance zero: the biharmonic problem then becomes two
  harmonic ones, which slivers do not harm, see `Laplacian_factorization`
  \throws No_convergence if an iteration does not reach its tolerance
  \complexity that of a sparse factorization, and of a solution per handle with free neighbours if
  these are few
  */
  template <MeasuredTriangulation Triangulation, NamedParameters NP = parameters::Parameters<>>
  Surface_deformation(const Triangulation& t, std::span<const std::uint32_t> handles,
                      Deformation_energy energy, Linear_solver solver,
                      const NP& np = parameters::default_values())
      : Surface_deformation(cotangent_laplacian(t), lumped_mass_matrix(t).diagonal(), handles,
                            energy, solver, internal::progress_of(np)) {
    internal::expect_names<internal::tags::visitor>(np);
  }

  /// solves as `solver_for()` chooses; see the other constructor.
  template <MeasuredTriangulation Triangulation, NamedParameters NP = parameters::Parameters<>>
  Surface_deformation(const Triangulation& t, std::span<const std::uint32_t> handles,
                      Deformation_energy energy = Deformation_energy::biharmonic,
                      const NP& np = parameters::default_values())
      : Surface_deformation(t, handles, energy, Linear_solver::automatic, np) {}

  /*!
  \brief factors the operator of two matrices.
  \param laplacian the matrix L, positive semidefinite
  \param mass the diagonal of the matrix M, positive except at isolated vertices; only the
  biharmonic energy needs it
  \param solver how to solve
  */
  Surface_deformation(const Eigen::SparseMatrix<double>& laplacian, const Eigen::VectorXd& mass,
                      std::span<const std::uint32_t> handles, Deformation_energy energy,
                      Linear_solver solver = Linear_solver::automatic)
      : Surface_deformation(laplacian, mass, handles, energy, solver,
                            [](Deformation_step) { return true; }) {}

  /// returns `cancelled` if a visitor stopped the constructor, else `done`.
  Status status() const { return status_; }

  /*!
  \brief moves the handles.
  \param displacements a row per handle as they were given, and a column per coordinate
  \return the displacements of all vertices
  \throws std::invalid_argument if there is not a row per handle, a number is not finite, or a
    handle that was given twice has two displacements
  \throws std::logic_error if the constructor was stopped
  \throws No_convergence if an iteration does not reach its tolerance
  \complexity linear in the entries of the factor, for each column
  */
  Eigen::MatrixXd displacements(const Eigen::MatrixXd& displacements) const;

private:
  Surface_deformation(const Eigen::SparseMatrix<double>& laplacian, const Eigen::VectorXd& mass,
                      std::span<const std::uint32_t> handles, Deformation_energy energy,
                      Linear_solver solver, const std::function<bool(Deformation_step)>& progress);
  void factor_biharmonic(const Eigen::SparseMatrix<double>& laplacian, const Eigen::VectorXd& mass,
                         Linear_solver solver);

  Status status_ = Status::done;
  std::vector<std::uint32_t> rows_; // handles, and what stays
  std::size_t handles_;
  Eigen::Index size_;
  std::optional<Fixed_values_solver> solver_; // of a matrix, or
  std::shared_ptr<const internal::Biharmonic_interpolation> by_handles_;
};

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_OPERATORS_EDITING_SURFACE_DEFORMATION_H
