// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_operators/distance/Heat_solver.h>
#include <CGAL/Intrinsic_operators/distance/Pinned_laplacian.h>
#include <CGAL/Intrinsic_operators/distance/distance_sources.h>
#include <CGAL/Intrinsic_operators/operators/Face_table.h>
#include <CGAL/Intrinsic_operators/solvers/Diffusion.h>
#include <CGAL/Intrinsic_operators/solvers/matrix_rows.h>
#include <CGAL/Intrinsic_triangulations/support/cmath.h>

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <complex>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <span>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

namespace internal {

// A ball in space that contains a piece of a source.
struct Source_ball {
  std::array<double, 3> center;
  double radius;
};

// Finds the distance in space to the nearest of many balls, a lower bound for ways on the surface.
// A tree halves the balls by coordinates in turn.
class Chord_bound {
public:
  explicit Chord_bound(std::vector<Source_ball> balls) : balls_(std::move(balls)) {
    for (const Source_ball& b : balls_) greatest_radius_ = std::max(greatest_radius_, b.radius);
    split(0, balls_.size(), 0);
  }

  // \return the least of a distance and the bound, negative if there are no balls
  double nearest(const std::array<double, 3>& p) const {
    double best = balls_.empty() ? 0 : std::numeric_limits<double>::infinity();
    search(p, 0, balls_.size(), 0, best);
    return best;
  }

private:
  void split(std::size_t begin, std::size_t end, std::size_t axis) {
    if (end - begin < 2) return;
    const std::size_t middle = begin + (end - begin) / 2;
    const auto at = [this](std::size_t i) {
      return balls_.begin() + static_cast<std::ptrdiff_t>(i);
    };
    std::nth_element(at(begin), at(middle), at(end), [axis](const auto& a, const auto& b) {
      return a.center[axis] < b.center[axis];
    });
    split(begin, middle, (axis + 1) % 3);
    split(middle + 1, end, (axis + 1) % 3);
  }

  // avoids the slow `std::hypot()` where squares are well within the range of doubles
  static double distance(const std::array<double, 3>& p, const std::array<double, 3>& q) {
    const double x = p[0] - q[0], y = p[1] - q[1], z = p[2] - q[2];
    const double squared = x * x + y * y + z * z;
    return squared > 1e-280 && squared < 1e280 ? std::sqrt(squared) : std::hypot(x, y, z);
  }

  void search(const std::array<double, 3>& p, std::size_t begin, std::size_t end, std::size_t axis,
              double& best) const {
    if (begin == end) return;
    const std::size_t middle = begin + (end - begin) / 2;
    const Source_ball& b = balls_[middle];
    best = std::min(best, distance(p, b.center) - b.radius);
    const double beyond = p[axis] - b.center[axis];
    const std::size_t other = (axis + 1) % 3;
    const bool is_left = beyond < 0;
    is_left ? search(p, begin, middle, other, best) : search(p, middle + 1, end, other, best);
    if (std::abs(beyond) - greatest_radius_ > best) return;
    is_left ? search(p, middle + 1, end, other, best) : search(p, begin, middle, other, best);
  }

  std::vector<Source_ball> balls_;
  double greatest_radius_ = 0;
};

// Balls about the sources: points for vertices; else about the nearest corner of the face.
// \return empty if the position of a source is unknown
static std::vector<Source_ball> source_balls(const Face_table& table, const Source_places& sources,
                                             const std::vector<std::array<double, 3>>& positions) {
  std::vector<Source_ball> balls;
  if (positions.empty()) return balls;
  const auto add = [&](int row, double radius) {
    balls.push_back({positions[static_cast<std::size_t>(row)], radius});
  };
  for (const int row : sources.rows) add(row, 0);
  for (const Source_side& s : sources.sides) {
    const Table_face& f = table.faces[s.face];
    for (const std::size_t k : {s.side, (s.side + 1) % 3}) add(f.rows[k], f.length(s.side) / 2);
  }
  for (const Source_segment& s : sources.segments) {
    const auto corners = table.faces[s.face].layout();
    const auto a = place_in_layout(corners, s.from), b = place_in_layout(corners, s.to);
    std::pair<double, int> nearest{std::numeric_limits<double>::infinity(), 0};
    for (std::size_t k = 0; k < 3; ++k)
      nearest = std::min(nearest, {std::max(std::abs(corners[k] - a), std::abs(corners[k] - b)),
                                   table.faces[s.face].rows[k]});
    add(nearest.second, nearest.first);
  }
  for (const Source_ball& b : balls)
    if (!std::isfinite(b.center[0])) return {};
  return balls;
}

// The lumped mass matrix, as a diagonal; ones at isolated vertices.
static Eigen::VectorXd row_areas(const Face_table& table, std::uint32_t sheets) {
  Eigen::VectorXd areas = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(table.number_of_rows));
  for (const Table_face& f : table.faces) {
    const double third = f.area() / 3 / sheets;
    for (const int row : f.rows) areas[row] += third;
  }
  return areas.unaryExpr([](double m) { return m > 0 ? m : 1; });
}

// A norm in a third of the time of `std::abs()`, where squares are well within the range of
// doubles: those that underflow are below 1e-27 of the sum.
static double norm_of(const std::complex<double>& x) {
  const double squared = std::norm(x);
  return squared > 1e-280 && squared < 1e280 ? std::sqrt(squared) : std::abs(x);
}

// Heat is positive. With negative weights, the solution may change signs far from the sources, but
// its magnitude still decreases along shortest paths.
static Heat<double> magnitudes(Heat<double> heat) {
  heat.value = heat.value.cwiseAbs();
  return heat;
}

Heat_solver::Heat_solver(const Eigen::SparseMatrix<double>& laplacian, Face_table table,
                         const Heat_options& options, std::uint32_t sheets, Heat_progress progress)
    : table_(std::move(table)), mean_edge_(table_.mean_edge_length()),
      time_(flow_time(options.time_factor, mean_edge_ * mean_edge_, table_.area())),
      component_(table_.components()), poisson_(laplacian, component_), sheets_(sheets),
      progress_(std::move(progress)) {
  const Eigen::VectorXd masses = row_areas(table_, sheets);
  insulated_ = std::make_shared<const Function_flow>(poisson_.laplacian(), time_,
                                                     poisson_.factor_with_multiple(time_, masses));
  is_cancelled_ = !progress_(Heat_step::heat_factored);
  if (!is_cancelled_ && options.border == Heat_border::average) make_cold_border(masses);
}

Eigen::VectorXd Heat_solver::distances(const Source_places& sources,
                                       const std::vector<std::array<double, 3>>& positions) {
  const std::span<const Source_places> sets(&sources, 1);
  const std::vector<Pins> pins = pins_of(sets);
  const std::vector<Heat<double>> found = heat(sets, pins);
  is_cancelled_ = !progress_(Heat_step::heat_found);
  if (is_cancelled_) return {};
  return fitted(found, sets, pins, positions, kept_);
}

Eigen::MatrixXd Heat_solver::columns(std::span<const Source_places> sets,
                                     const std::vector<std::array<double, 3>>& positions,
                                     Pinned_laplacian::Kept& kept) const {
  const std::vector<Pins> pins = pins_of(sets);
  return fitted(heat(sets, pins), sets, pins, positions, kept);
}

std::vector<Pinned_laplacian::Pins>
Heat_solver::pins_of(std::span<const Source_places> sets) const {
  std::vector<Pins> pins;
  for (const Source_places& s : sets) pins.push_back(distances_near_sources(table_, s));
  return pins;
}

Eigen::MatrixXd Heat_solver::fitted(const std::vector<Heat<double>>& heat,
                                    std::span<const Source_places> sets, std::span<const Pins> pins,
                                    const std::vector<std::array<double, 3>>& positions,
                                    Pinned_laplacian::Kept& kept) const {
  Eigen::MatrixXd right(static_cast<Eigen::Index>(table_.number_of_rows),
                        static_cast<Eigen::Index>(sets.size()));
  for (Eigen::Index c = 0; c < right.cols(); ++c) right.col(c) = divergence(heat[row_number(c)]);
  Eigen::MatrixXd d = poisson_.solve(right, pins, kept);
  for (Eigen::Index c = 0; c < d.cols(); ++c) {
    const Chord_bound chord(source_balls(table_, sets[row_number(c)], positions));
    const Pins& own = pins[row_number(c)];
    auto pin = own.begin(); // the next one, in the order of rows
    for (Eigen::Index r = 0; r < d.rows(); ++r) {
      if (pin != own.end() && pin->first == r) {
        ++pin;
      } else {
        double bound = 0;
        if (const std::size_t i = row_number(r);
            i < positions.size() && std::isfinite(positions[i][0]))
          bound = std::max(0.0, chord.nearest(positions[i]));
        d(r, c) = std::max(d(r, c), bound);
      }
      d(r, c) = table_.unscaled(d(r, c));
    }
  }
  return d;
}

void Heat_solver::make_cold_border(const Eigen::VectorXd& masses) {
  is_on_border_.assign(table_.number_of_rows, 0);
  table_.for_each_border_side([this](const Table_face& f, std::size_t k) {
    is_on_border_[row_number(f.rows[k])] = is_on_border_[row_number(f.rows[(k + 1) % 3])] = 1;
  });
  const auto on_border = std::count(is_on_border_.begin(), is_on_border_.end(), 1);
  if (on_border == 0 || on_border == masses.size()) return;
  const Eigen::SparseMatrix<double> flow = time_ * *poisson_.laplacian();
  Shared_analysis none;
  cold_ = std::make_shared<const Function_flow>(
      with_fixed_rows(flow, is_on_border_), diagonal_with_fixed_rows(flow, masses, is_on_border_),
      none);
  is_cancelled_ = !progress_(Heat_step::heat_factored);
}

// Marks the rows of components with pins.
std::vector<char> Heat_solver::reached(const Pins& pins) const {
  std::vector<char> is_reached(table_.number_of_rows, 0);
  for (const auto& [row, value] : pins) is_reached[component_[row_number(row)]] = 1;
  for (std::size_t r = 0; r < is_reached.size(); ++r) is_reached[r] = is_reached[component_[r]];
  return is_reached;
}

std::vector<Heat<double>> Heat_solver::heat(std::span<const Source_places> sets,
                                            std::span<const Pins> pins) const {
  std::vector<std::vector<char>> is_reached;
  std::vector<Heat<double>> starts;
  for (std::size_t k = 0; k < sets.size(); ++k) {
    is_reached.push_back(reached(pins[k]));
    starts.emplace_back(initial_heat(sets[k]));
  }
  std::vector<Heat<double>> all = insulated_->all(starts, {is_reached.begin(), is_reached.end()});
  for (Heat<double>& h : all) h = magnitudes(std::move(h));
  if (!cold_) return all;
  for (std::size_t k = 0; k < sets.size(); ++k)
    for (std::size_t r = 0; r < is_on_border_.size(); ++r)
      if (is_on_border_[r] != 0)
        starts[k].value[static_cast<Eigen::Index>(r)] = is_reached[k][r] = 0;
  std::vector<Heat<double>> inside =
      cold_->all(std::move(starts), {is_reached.begin(), is_reached.end()});
  for (std::size_t k = 0; k < sets.size(); ++k) {
    inside[k] = magnitudes(std::move(inside[k]));
    const double unit = std::ldexp(1.0, inside[k].exponent - all[k].exponent);
    for (Eigen::Index r = 0; r < all[k].value.size(); ++r)
      all[k].value[r] += unit * inside[k].at(r, all[k].level[row_number(r)]);
  }
  return all;
}

Eigen::VectorXd Heat_solver::initial_heat(const Source_places& sources) const {
  Eigen::VectorXd start = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(table_.number_of_rows));
  for (const int row : sources.rows) start[row] += 1;
  for (const Source_side& s : sources.sides) {
    const Table_face& f = table_.faces[s.face];
    for (const std::size_t k : {s.side, (s.side + 1) % 3})
      start[f.rows[k]] += f.length(s.side) / (2 * mean_edge_);
  }
  for (const Source_segment& s : sources.segments) {
    const Table_face& f = table_.faces[s.face];
    const auto corners = f.layout();
    const double length =
        std::abs(place_in_layout(corners, s.to) - place_in_layout(corners, s.from));
    const double strength = s.part * (s.is_point() ? 1 : length / mean_edge_);
    for (std::size_t k = 0; k < 3; ++k) start[f.rows[k]] += strength * (s.from[k] + s.to[k]) / 2;
  }
  return start;
}

Eigen::VectorXd Heat_solver::divergence(const Heat<double>& heat) const {
  Eigen::VectorXd result = Eigen::VectorXd::Zero(heat.value.size());
  for (const Table_face& f : table_.faces) {
    int level = heat.level[row_number(f.rows[0])];
    for (const int row : f.rows) level = std::min(level, heat.level[row_number(row)]);
    const auto corners = f.layout();
    const auto at_corners = divergence_at_corners(
        corners, descent(corners, {heat.at(f.rows[0], level), heat.at(f.rows[1], level),
                                   heat.at(f.rows[2], level)}));
    for (std::size_t k = 0; k < 3; ++k) result[f.rows[k]] += at_corners[k] / sheets_;
  }
  return result;
}

std::complex<double> Heat_solver::descent(const std::array<std::complex<double>, 3>& corners,
                                          const std::array<double, 3>& u) {
  const double first = u[1] - u[0], second = u[2] - u[0];
  const double greatest = std::max(std::abs(first), std::abs(second));
  if (!(greatest > 0)) return 0;
  // up to a positive factor: sides by values, a quarter turn to the left; sides sum to zero
  std::complex<double> gradient =
      first / greatest * (corners[0] - corners[2]) + second / greatest * (corners[1] - corners[0]);
  gradient = {-gradient.imag(), gradient.real()};
  const double norm = norm_of(gradient);
  return norm > 0 ? -gradient / norm : 0;
}

} // namespace internal

} // namespace CGAL::Intrinsic_triangulations
