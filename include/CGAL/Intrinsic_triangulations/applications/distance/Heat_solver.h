// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_APPLICATIONS_DISTANCE_HEAT_SOLVER_H
#define CGAL_INTRINSIC_TRIANGULATIONS_APPLICATIONS_DISTANCE_HEAT_SOLVER_H

#include <CGAL/Intrinsic_triangulations/applications/distance/Chord_bound.h>
#include <CGAL/Intrinsic_triangulations/applications/distance/Diffusion.h>
#include <CGAL/Intrinsic_triangulations/applications/distance/Pinned_laplacian.h>
#include <CGAL/Intrinsic_triangulations/applications/distance/near_distances.h>
#include <CGAL/Intrinsic_triangulations/operators/Face_table.h>

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <cstddef>
#include <optional>
#include <stdexcept>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/// How heat behaves at the border, for `Heat_distance`.
enum class Heat_border {
  insulated, ///< no flux: the gradient runs along the border (Neumann)
  average    ///< the mean of that and of a border that is kept cold (Dirichlet)
};

namespace internal {

// What a field of one vector in a face adds to the divergence at its corners: the integral of <v, grad hat function>.
// \param v in the frame of side 0
inline std::array<double, 3> divergence_at_corners(const std::array<std::complex<double>, 3>& corners,
                                                   std::complex<double> v) {
  std::array<double, 3> result;
  for (std::size_t k = 0; k < 3; ++k) { // area times gradient: the opposite side, a quarter turn to the left, by 2
    const std::complex<double> side = corners[(k + 2) % 3] - corners[(k + 1) % 3];
    result[k] = (side.real() * v.imag() - side.imag() * v.real()) / 2;
  }
  return result;
}

// The lumped mass matrix, as a diagonal.
inline Eigen::VectorXd row_areas(const Face_table& table, int sheets) {
  Eigen::VectorXd areas = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(table.number_of_rows));
  for (const Table_face& f : table.faces)
    for (const int row : f.rows) areas[row] += f.area() / 3 / sheets;
  return areas;
}

// Adds to a diagonal, in which zeros become ones: rows of isolated vertices.
inline Eigen::SparseMatrix<double> plus_diagonal(Eigen::SparseMatrix<double> m,
                                                 const Eigen::VectorXd& diagonal) {
  for (int r = 0; r < m.cols(); ++r) {
    double& d = m.coeffRef(r, r);
    d += diagonal[r];
    if (d == 0) d = 1;
  }
  return m;
}

// The heat method on a table of faces, in scaled units.
class Heat_solver {
public:
  Heat_solver(Face_table table, const Eigen::SparseMatrix<double>& laplacian, double time_factor,
              Heat_border border, int sheets)
      : table_(std::move(table)), time_(time_factor * std::pow(table_.mean_edge_length(), 2)),
        component_(table_.components()), poisson_(laplacian, component_), sheets_(sheets) {
    if (!(time_factor > 0) || !std::isfinite(time_))
      throw std::invalid_argument("the time factor must be positive and finite");
    const Eigen::SparseMatrix<double> flow =
        plus_diagonal(time_ * laplacian, row_areas(table_, sheets));
    insulated_.emplace(flow);
    if (border == Heat_border::average) make_cold_border(flow);
  }

  const Face_table& table() const { return table_; }
  double time() const { return table_.unscaled(table_.unscaled(time_)); }

  // \return by rows, in the units of the input
  Eigen::VectorXd distances(const Source_places& sources, const Chord_bound& chord,
                            const std::vector<std::array<double, 3>>& positions) {
    const Pinned_laplacian::Pins pins = distances_near_sources(table_, sources);
    Eigen::VectorXd d = poisson_.solve(divergence(heat(sources, pins)), pins);
    for (Eigen::Index r = 0; r < d.size(); ++r) {
      if (pins.count(static_cast<int>(r)) == 0) {
        double bound = 0;
        if (const auto i = static_cast<std::size_t>(r);
            i < positions.size() && std::isfinite(positions[i][0]))
          bound = std::max(0.0, chord.nearest(positions[i]));
        d[r] = std::max(d[r], bound);
      }
      d[r] = table_.unscaled(d[r]);
    }
    return d;
  }

private:
  static std::size_t number(Eigen::Index i) { return static_cast<std::size_t>(i); }

  void make_cold_border(const Eigen::SparseMatrix<double>& flow) {
    std::vector<char> is_inside(table_.number_of_rows, 1);
    table_.for_each_border_side([&](const Table_face& f, std::size_t k) {
      is_inside[number(f.rows[k])] = is_inside[number(f.rows[(k + 1) % 3])] = 0;
    });
    for (std::size_t r = 0; r < is_inside.size(); ++r)
      if (is_inside[r] != 0) inside_.push_back(static_cast<int>(r));
    if (inside_.size() < is_inside.size() && !inside_.empty())
      cold_.emplace(principal_submatrix(flow, inside_));
  }

  Heat<double> heat(const Source_places& sources, const Pinned_laplacian::Pins& pins) const {
    std::vector<char> is_reached(table_.number_of_rows, 0);
    for (const auto& [row, value] : pins) is_reached[number(component_[number(row)])] = 1;
    for (std::size_t r = 0; r < is_reached.size(); ++r)
      is_reached[r] = is_reached[number(component_[r])];
    const Eigen::VectorXd start = initial_heat(sources);
    Heat<double> all = (*insulated_)(start, is_reached);
    if (cold_) {
      std::vector<char> reached_inside;
      for (const int r : inside_) reached_inside.push_back(is_reached[number(r)]);
      const Heat<double> inside = (*cold_)(start(inside_), reached_inside);
      for (std::size_t i = 0; i < inside_.size(); ++i)
        all.value[inside_[i]] +=
            inside.at(static_cast<Eigen::Index>(i), all.level[number(inside_[i])]);
    }
    return all;
  }

  // Curves count by their length in mean edges, points once.
  Eigen::VectorXd initial_heat(const Source_places& sources) const {
    const double unit = table_.mean_edge_length();
    Eigen::VectorXd start = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(table_.number_of_rows));
    for (const int row : sources.rows) start[row] += 1;
    for (const Source_side& s : sources.sides) {
      const Table_face& f = table_.faces[s.face];
      for (const std::size_t k : {s.side, (s.side + 1) % 3})
        start[f.rows[k]] += f.length(s.side) / (2 * unit);
    }
    for (const Source_segment& s : sources.segments) {
      const Table_face& f = table_.faces[s.face];
      const auto corners = f.layout();
      const double length =
          std::abs(place_in_layout(corners, s.to) - place_in_layout(corners, s.from));
      const double strength = s.from == s.to ? 1 : length / unit;
      for (std::size_t k = 0; k < 3; ++k)
        start[f.rows[k]] += strength * (s.from[k] + s.to[k]) / 2;
    }
    return start;
  }

  // of the field of unit vectors along which heat decreases
  Eigen::VectorXd divergence(const Heat<double>& heat) const {
    Eigen::VectorXd result = Eigen::VectorXd::Zero(heat.value.size());
    for (const Table_face& f : table_.faces) {
      int level = heat.level[number(f.rows[0])];
      for (const int row : f.rows) level = std::min(level, heat.level[number(row)]);
      const auto corners = f.layout();
      const auto at_corners =
          divergence_at_corners(corners, descent(corners, {heat.at(f.rows[0], level),
                                                           heat.at(f.rows[1], level),
                                                           heat.at(f.rows[2], level)}));
      for (std::size_t k = 0; k < 3; ++k) result[f.rows[k]] += at_corners[k] / sheets_;
    }
    return result;
  }

  // the unit vector against the gradient of a function, zero if that is constant
  static std::complex<double> descent(const std::array<std::complex<double>, 3>& corners,
                                      const std::array<double, 3>& u) {
    const double greatest = std::max({std::abs(u[0]), std::abs(u[1]), std::abs(u[2])});
    if (!(greatest > 0)) return 0;
    std::complex<double> gradient = 0; // up to a positive factor
    const std::complex<double> i(0, 1);
    for (std::size_t k = 0; k < 3; ++k)
      gradient += u[k] / greatest * (i * (corners[(k + 2) % 3] - corners[(k + 1) % 3]));
    const double norm = std::abs(gradient);
    return norm > 0 ? -gradient / norm : 0;
  }

  Face_table table_;
  double time_;
  std::vector<int> component_;
  Pinned_laplacian poisson_;
  std::optional<Diffusion<double>> insulated_, cold_;
  std::vector<int> inside_; // the rows that are not on the border
  int sheets_;
};

} // namespace internal

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_APPLICATIONS_DISTANCE_HEAT_SOLVER_H
