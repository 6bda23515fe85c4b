// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_operators/distance/Pinned_laplacian.h>
#include <CGAL/Intrinsic_operators/distance/Signed_heat_distance.h>
#include <CGAL/Intrinsic_operators/distance/distance_sources.h>
#include <CGAL/Intrinsic_operators/elements/crouzeix_raviart.h>
#include <CGAL/Intrinsic_operators/operators/Face_table.h>
#include <CGAL/Intrinsic_operators/solvers/Diffusion.h>
#include <CGAL/Intrinsic_operators/solvers/matrix_rows.h>
#include <CGAL/Intrinsic_operators/solvers/ordering/Symbolic_factorization.h>
#include <CGAL/Intrinsic_triangulations/support/cmath.h>

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <algorithm>
#include <complex>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <memory>
#include <set>
#include <stdexcept>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

namespace internal {

// The mean of the squared distances of neighbouring nodes, which are the midpoints of edges.
static double squared_spacing(const Face_table& table) {
  return table.mean_of_edges(
      [](const Table_face& f, std::size_t k) { return f.squared_lengths[k] / 4; });
}

// Where vertices are eliminated: in the Laplacian, or, if that lacks entries of edges opposite of
// right angles, in a matrix with entries of all edges. (The order of the Laplacian of a square grid
// of 6,400 vertices took 2 s and half a gigabyte for the factor of edges, this one 0.05 s.)
static std::vector<int> elimination_places(const Face_table& table, Pinned_laplacian& poisson) {
  const Eigen::SparseMatrix<double>& laplacian = *poisson.laplacian();
  std::vector<Eigen::Triplet<double>> entries;
  bool has_all = true;
  table.for_each_edge([&](const Table_face& f, std::size_t k) {
    const int i = f.rows[k], j = f.rows[(k + 1) % 3];
    has_all = has_all && laplacian.coeff(i, j) != 0;
    for (const auto& [r, c] : {std::pair(i, i), std::pair(i, j), std::pair(j, i), std::pair(j, j)})
      entries.emplace_back(r, c, 1);
  });
  if (has_all) return poisson.analysis().place;
  Eigen::SparseMatrix<double> edges(laplacian.rows(), laplacian.cols());
  edges.setFromTriplets(entries.begin(), entries.end());
  return Symbolic_factorization(edges).place;
}

// Orders edges by the end that is eliminated first among the vertices. Around a set of eliminated
// vertices as many edges remain as vertices. The factor has fewer entries than with edges ordered
// by minimum degree (0.83 times as many on armadillo), and ordering three times as many edges as
// vertices takes longer.
// \param place of vertices in their elimination
static std::vector<int> order_of_edges(const Face_table& table, const std::vector<int>& place) {
  std::vector<std::vector<std::pair<int, int>>> at(place.size()); // minus the other place, and edge
  std::vector<int> order;
  std::vector<char> is_removed(table.number_of_edges, 1);
  table.for_each_edge([&](const Table_face& f, std::size_t k) {
    const auto edge = static_cast<int>(f.halfedges[k] / 2);
    const auto [first, last] =
        std::minmax(place[row_number(f.rows[k])], place[row_number(f.rows[(k + 1) % 3])]);
    at[row_number(first)].push_back({-last, edge});
    is_removed[row_number(edge)] = 0;
  });
  for (std::size_t e = 0; e < is_removed.size(); ++e)
    if (is_removed[e] != 0) order.push_back(static_cast<int>(e));
  for (auto& edges : at) {
    std::ranges::sort(edges);
    for (const auto& [other, edge] : edges) order.push_back(edge);
  }
  return order;
}

static std::shared_ptr<const Vector_flow> vector_flow(const Face_table& table, double time,
                                                      const std::vector<int>& place) {
  Eigen::SparseMatrix<std::complex<double>> l = edge_connection_laplacian(table, time);
  Shared_analysis analysis =
      std::make_shared<const Symbolic_factorization>(l, order_of_edges(table, place));
  return std::make_shared<const Vector_flow>(
      std::move(l), edge_areas(table).unaryExpr([](double a) { return a > 0 ? a : 1; }), analysis);
}

Signed_heat_solver::Signed_heat_solver(Face_table table,
                                       const Eigen::SparseMatrix<double>& laplacian,
                                       double time_factor, Heat_progress progress)
    : table_(std::move(table)),
      time_(flow_time(time_factor, squared_spacing(table_), table_.area())),
      component_(table_.components()), poisson_(laplacian, component_),
      flow_(vector_flow(table_, time_, elimination_places(table_, poisson_))),
      progress_(std::move(progress)), is_cancelled_(!progress_(Heat_step::heat_factored)) {}

Eigen::VectorXd Signed_heat_solver::distances(const Source_places& curves) {
  if (!curves.rows.empty() || std::ranges::any_of(curves.segments, &Source_segment::is_point))
    throw std::invalid_argument(
        "a vertex or a point has no sides; signed distances are those from curves");
  const Pinned_laplacian::Pins pins = signed_distances_near(curves);
  const Eigen::VectorXd divergences = divergence(normals(curves, pins));
  is_cancelled_ = !progress_(Heat_step::heat_found);
  if (is_cancelled_) return {};
  Eigen::VectorXd d = poisson_.solve(divergences, {&pins, 1}, kept_);
  for (double& x : d) x = table_.unscaled(x);
  return d;
}

Heat<std::complex<double>> Signed_heat_solver::normals(const Source_places& curves,
                                                       const Pinned_laplacian::Pins& pins) const {
  const Complex to_right(0, -1);
  Eigen::VectorXcd start =
      Eigen::VectorXcd::Zero(static_cast<Eigen::Index>(table_.number_of_edges));
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
      start[f.halfedges[k] / 2] += s.part * (1 - s.from[opposite] - s.to[opposite]) * to_right *
                                   along * std::conj(frames[k]);
    }
  }
  std::vector<char> has_curve(table_.number_of_rows, 0), is_reached(table_.number_of_edges, 0);
  for (const auto& [row, value] : pins) has_curve[component_[row_number(row)]] = 1;
  for (const Table_face& f : table_.faces)
    for (const std::uint32_t h : f.halfedges)
      is_reached[h / 2] = has_curve[component_[row_number(f.rows[0])]];
  return (*flow_)(start, is_reached);
}

Eigen::VectorXd Signed_heat_solver::divergence(const Heat<Complex>& field) const {
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

namespace {

using Complex = std::complex<double>;

// How far a point is from the nearest piece of a curve, and with a sign from the line of the piece.
// Where two pieces are as near, at their joint, it is the distance from there, on the side of the
// line that is farther away.
struct Nearest_piece {
  double distance = std::numeric_limits<double>::infinity();
  double from_line = 0;

  void add(Complex p, Complex a, Complex b) {
    constexpr double joint = 1 + 0x1p-30; // the same distance but for rounding
    const double here = distance_to_segment(p, a, b),
                 line = -std::imag(std::conj(b - a) * (p - a)) / std::abs(b - a);
    if (here <= joint * distance && distance <= joint * here)
      from_line = std::copysign(here, std::abs(line) > std::abs(from_line) ? line : from_line);
    else if (here < distance)
      from_line = line;
    distance = std::min(distance, here);
  }
};

// Adds whole edges of a curve at opposite corners, where other pieces have been added.
void add_sides(const Face_table& table, const std::vector<Source_side>& sides,
               std::map<int, Nearest_piece>& near) {
  std::set<std::uint32_t> along; // halfedges in the direction of the curve
  for (const Source_side& s : sides)
    along.insert(table.faces[s.face].halfedges[s.side] ^ (s.is_left ? 0U : 1U));
  if (near.empty() || along.empty()) return;
  for (const Table_face& f : table.faces)
    for (std::size_t k = 0; k < 3; ++k) {
      const auto place = near.find(f.rows[(k + 2) % 3]);
      if (place == near.end()) continue;
      const auto corners = f.layout();
      const Complex a = corners[k], b = corners[(k + 1) % 3], p = corners[(k + 2) % 3];
      if (along.contains(f.halfedges[k])) place->second.add(p, a, b);
      if (along.contains(f.halfedges[k] ^ 1U)) place->second.add(p, b, a);
    }
}

} // namespace

Pinned_laplacian::Pins
Signed_heat_solver::signed_distances_near(const Source_places& curves) const {
  Pinned_laplacian::Pins pins;
  std::map<int, Nearest_piece> near;
  for (const Source_segment& s : curves.segments) {
    const Table_face& f = table_.faces[s.face];
    const auto corners = f.layout();
    const Complex a = place_in_layout(corners, s.from), b = place_in_layout(corners, s.to);
    if (!(std::abs(b - a) > 0)) continue;
    for (std::size_t k = 0; k < 3; ++k) {
      const bool is_on_line = s.is_along(k) || s.is_along((k + 2) % 3);
      if (is_on_line)
        pins[f.rows[k]] = 0;
      else if (!s.is_along((k + 1) % 3))
        near[f.rows[k]].add(corners[k], a, b);
    }
  }
  add_sides(table_, curves.sides, near);
  for (const auto& [row, nearest] : near) pins.insert({row, nearest.from_line});
  for (const Source_side& s : curves.sides)
    for (const std::size_t k : {std::size_t{s.side}, (std::size_t{s.side} + 1) % 3})
      pins[table_.faces[s.face].rows[k]] = 0;
  return pins;
}

} // namespace internal

} // namespace CGAL::Intrinsic_triangulations
