// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_APPLICATIONS_DISTANCE_SIGNED_HEAT_SOLVER_H
#define CGAL_INTRINSIC_TRIANGULATIONS_APPLICATIONS_DISTANCE_SIGNED_HEAT_SOLVER_H

#include <CGAL/Intrinsic_triangulations/applications/distance/Diffusion.h>
#include <CGAL/Intrinsic_triangulations/applications/distance/Heat_solver.h>
#include <CGAL/Intrinsic_triangulations/applications/distance/Pinned_laplacian.h>
#include <CGAL/Intrinsic_triangulations/applications/distance/distance_sources.h>
#include <CGAL/Intrinsic_triangulations/applications/distance/near_distances.h>
#include <CGAL/Intrinsic_triangulations/operators/Face_table.h>
#include <CGAL/Intrinsic_triangulations/operators/crouzeix_raviart.h>

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <cstddef>
#include <map>
#include <stdexcept>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// The signed heat method on a table of faces, in scaled units.
class Signed_heat_solver {
  using Complex = std::complex<double>;

public:
  Signed_heat_solver(Face_table table, const Eigen::SparseMatrix<double>& laplacian,
                     double time_factor)
      : table_(std::move(table)), time_(time_factor * std::pow(table_.mean_edge_length(), 2)),
        component_(table_.components()), poisson_(laplacian, component_),
        flow_(flow_matrix(time_factor)) {}

  const Face_table& table() const { return table_; }
  double time() const { return table_.unscaled(table_.unscaled(time_)); }

  // \return by rows, in the units of the input
  Eigen::VectorXd distances(const Source_places& curves) {
    if (!curves.rows.empty())
      throw std::invalid_argument("a vertex or a point has no sides; signed distances are those from curves");
    const Pinned_laplacian::Pins pins = signed_distances_near(curves);
    Eigen::VectorXd d = poisson_.solve(divergence(normals(curves, pins)), pins);
    for (double& x : d) x = table_.unscaled(x);
    return d;
  }

private:
  static std::size_t number(Eigen::Index i) { return static_cast<std::size_t>(i); }

  Eigen::SparseMatrix<Complex> flow_matrix(double time_factor) const {
    if (!(time_factor > 0) || !std::isfinite(time_))
      throw std::invalid_argument("the time factor must be positive and finite");
    Eigen::SparseMatrix<Complex> m = time_ * edge_connection_laplacian(table_);
    const Eigen::VectorXd areas = edge_areas(table_);
    for (int e = 0; e < m.cols(); ++e) m.coeffRef(e, e) += areas[e] > 0 ? areas[e] : 1;
    m.makeCompressed();
    return m;
  }

  // The normals on the right of the curves, diffused.
  Heat<Complex> normals(const Source_places& curves, const Pinned_laplacian::Pins& pins) const {
    const Complex to_right(0, -1);
    Eigen::VectorXcd start = Eigen::VectorXcd::Zero(static_cast<Eigen::Index>(table_.number_of_edges));
    for (const Source_side& s : curves.sides) {
      const Table_face& f = table_.faces[s.face];
      const std::uint32_t h = f.halfedges[s.side];
      const double along = (h % 2 == 0) == s.is_left ? 1 : -1;
      start[h / 2] += f.length(s.side) * along * to_right;
    }
    for (const Source_segment& s : curves.segments) {
      const Table_face& f = table_.faces[s.face];
      const auto corners = f.layout();
      const auto frames = side_frames(f);
      const Complex along = place_in_layout(corners, s.to) - place_in_layout(corners, s.from);
      for (std::size_t k = 0; k < 3; ++k) { // the hat function of the side at the middle
        const std::size_t opposite = (k + 2) % 3;
        start[f.halfedges[k] / 2] +=
            (1 - s.from[opposite] - s.to[opposite]) * to_right * along * std::conj(frames[k]);
      }
    }
    std::vector<char> has_curve(table_.number_of_rows, 0), is_reached(table_.number_of_edges, 0);
    for (const auto& [row, value] : pins) has_curve[number(component_[number(row)])] = 1;
    for (const Table_face& f : table_.faces)
      for (const std::uint32_t h : f.halfedges)
        is_reached[h / 2] = has_curve[number(component_[number(f.rows[0])])];
    return flow_(start, is_reached);
  }

  // of the field of unit vectors that have the directions of the diffused normals in the middle of the faces
  Eigen::VectorXd divergence(const Heat<Complex>& field) const {
    Eigen::VectorXd result = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(table_.number_of_rows));
    for (const Table_face& f : table_.faces) {
      int level = field.level[f.halfedges[0] / 2];
      for (const std::uint32_t h : f.halfedges) level = std::min(level, field.level[h / 2]);
      const auto frames = side_frames(f);
      Complex sum = 0;
      for (std::size_t k = 0; k < 3; ++k)
        sum += field.at(static_cast<Eigen::Index>(f.halfedges[k] / 2), level) * frames[k];
      const double norm = std::abs(sum);
      if (!(norm > 0)) continue;
      const auto at_corners = divergence_at_corners(f.layout(), sum / norm);
      for (std::size_t k = 0; k < 3; ++k) result[f.rows[k]] += at_corners[k];
    }
    return result;
  }

  // Zero at vertices of the curves. At the corners of a face that a curve goes through, the distance from its line there, which is
  // linear in the face: it is zero where the curve is.
  Pinned_laplacian::Pins signed_distances_near(const Source_places& curves) const {
    std::map<int, std::pair<double, double>> near; // distance from the curve and signed distance from the line
    for (const Source_segment& s : curves.segments) {
      const Table_face& f = table_.faces[s.face];
      const auto corners = f.layout();
      const Complex a = place_in_layout(corners, s.from), b = place_in_layout(corners, s.to);
      const double length = std::abs(b - a);
      if (!(length > 0)) continue;
      for (std::size_t k = 0; k < 3; ++k) {
        const double from_line = -std::imag(std::conj(b - a) * (corners[k] - a)) / length;
        const std::pair<double, double> here{distance_to_segment(corners[k], a, b), from_line};
        const auto [place, is_new] = near.insert({f.rows[k], here});
        if (!is_new && here.first < place->second.first) place->second = here;
      }
    }
    Pinned_laplacian::Pins pins;
    for (const auto& [row, distances] : near) pins[row] = distances.second;
    for (const Source_side& s : curves.sides)
      for (const std::size_t k : {std::size_t{s.side}, (std::size_t{s.side} + 1) % 3})
        pins[table_.faces[s.face].rows[k]] = 0;
    return pins;
  }

  Face_table table_;
  double time_;
  std::vector<int> component_;
  Pinned_laplacian poisson_;
  Diffusion<Complex> flow_;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_APPLICATIONS_DISTANCE_SIGNED_HEAT_SOLVER_H
