// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_conformal/angles/Ideal_surface.h>
#include <CGAL/Intrinsic_conformal/angles/Prescribed_angles.h>
#include <CGAL/Intrinsic_conformal/layout/conformal_sphere.h>
#include <CGAL/Intrinsic_conformal/metric/conformal_metric.h>
#include <CGAL/Intrinsic_triangulations/connectivity/Gluing.h>
#include <CGAL/Intrinsic_triangulations/support/Invalid_input.h>
#include <CGAL/Intrinsic_triangulations/support/cmath.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numbers>
#include <optional>
#include <span>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

namespace {

// A surface whose factors are those given times others.
class Rescaled_surface final : public Ideal_surface {
public:
  Rescaled_surface(Ideal_surface& surface, const std::vector<Double_double>& base)
      : surface_(surface), base_(base) {}

  const std::vector<std::uint32_t>& row_of_vertex() const override {
    return surface_.row_of_vertex();
  }
  std::size_t number_of_rows() const override { return surface_.number_of_rows(); }
  int scale_exponent() const override { return surface_.scale_exponent(); }
  std::uint32_t sheets() const override { return surface_.sheets(); }
  std::optional<std::size_t> scale(std::span<const Double_double> factors) override {
    std::vector<Double_double> product(base_);
    for (std::size_t i = 0; i < product.size(); ++i) product[i] = product[i] * factors[i];
    return surface_.scale(product);
  }
  void read(std::vector<Ideal_face>& faces) const override { surface_.read(faces); }
  std::optional<std::vector<Enclosed_ideal_face>> enclosures() const override {
    return surface_.enclosures();
  }

private:
  Ideal_surface& surface_;
  const std::vector<Double_double>& base_;
};

std::vector<Double_double> factors_of(const Conformal_metric& m) {
  std::vector<Double_double> result(m.scale_factors.begin(), m.scale_factors.end());
  for (std::size_t v = 0; v < result.size(); ++v) result[v] = result[v] + m.scale_rests[v];
  return result;
}

// The metric of a sphere without the pole, and what is known about it.
struct Punctured_sphere {
  Conformal_metric metric;
  std::vector<double> areas; // of each row, before scaling
  std::uint32_t pole = 0;    // a row
  unsigned rounds = 0;
  bool is_convex = false;
};

// The angle of a face at corner k.
double angle_at(const Ideal_face& f, std::size_t k) {
  const double a = f.lambda[k], b = f.lambda[(k + 2) % 3], c = f.lambda[(k + 1) % 3];
  const double cosine = (a / b + b / a - c / a * (c / b)) / 2;
  return std::acos(std::clamp(cosine, -1., 1.));
}

double area_of(const Ideal_face& f) {
  return f.lambda[0] * f.lambda[2] * std::sin(angle_at(f, 0)) / 2;
}

// Finds the neighbours of the pole, round after round.
class Sphere_puncturer {
public:
  explicit Sphere_puncturer(Ideal_surface& surface)
      : surface_(surface), base_(surface.number_of_rows(), 1) {
    surface_.scale(base_);
    surface_.read(faces_);
    result_.areas.assign(base_.size(), 0);
    for (const Ideal_face& f : faces_)
      for (const int row : f.rows) result_.areas[static_cast<std::size_t>(row)] += area_of(f) / 3;
    check_sphere();
    make_round();
    start_ = result_;
    poles_ = possible_poles();
  }

  // Rows that can be at infinity: the one with most neighbours, and others.
  const std::vector<std::uint32_t>& poles() const { return poles_; }

  Punctured_sphere run(std::uint32_t pole) {
    result_ = start_;
    result_.pole = pole;
    base_ = factors_of(start_.metric);
    surface_.scale(base_);
    surface_.read(faces_);
    std::vector<std::uint32_t> fixed = neighbours();
    // Neighbours are right long before rounding ends the iteration: on the data set 1e-2 and 1e-7
    // give the same spheres as this residual. 5 rounds are enough there, but not if it is
    // stretched.
    constexpr double enough = 1e-4;
    while (result_.rounds < 20 && !result_.is_convex && result_.metric.residual < enough) {
      const Punctured_sphere before = result_;
      ++result_.rounds;
      if (!normalise(fixed)) return restored(before);
      flatten(fixed);
      if (result_.rounds > 1 && !(result_.metric.residual < enough)) return restored(before);
      std::vector<std::uint32_t> now = neighbours();
      remove_reflex(now);
      result_.is_convex = now == fixed;
      fixed = std::move(now);
    }
    return result_;
  }

private:
  // A round that found no metric is undone: the map before is one, though it is not convex.
  Punctured_sphere restored(Punctured_sphere before) const {
    surface_.scale(factors_of(before.metric));
    if (before.rounds == 0) {
      before.metric.status = Status::stalled;
      before.metric.residual = std::numeric_limits<double>::infinity();
      before.metric.proven_residual.reset();
    }
    return before;
  }

  void check_sphere() const {
    const Ideal_components components = components_of(faces_, base_.size());
    const auto isolated = std::ranges::count(components.of_row, Gluing::none);
    const std::size_t corners = base_.size() - static_cast<std::size_t>(isolated);
    if (components.faces.size() != 1 || 2 * corners != faces_.size() + 4)
      throw Invalid_input(Element_kind::none, 0,
                          "only a connected closed surface of genus 0 is a sphere, but there are "
                          "more components, or handles, or two sheets; take components one by one, "
                          "and lay surfaces with handles or a border out in the plane");
  }

  // Rows with neighbours that are different: the one with the most, and others all over the mesh.
  std::vector<std::uint32_t> possible_poles() const {
    std::vector<std::vector<int>> around(base_.size());
    for (const Ideal_face& f : faces_)
      for (std::size_t k = 0; k < 3; ++k)
        around[static_cast<std::size_t>(f.rows[k])].push_back(f.rows[(k + 1) % 3]);
    std::vector<std::uint32_t> possible;
    std::size_t best = 0, most = 0;
    for (std::uint32_t v = 0; v < around.size(); ++v) {
      std::vector<int>& rows = around[v];
      std::ranges::sort(rows);
      if (rows.empty() || std::ranges::find(rows, static_cast<int>(v)) != rows.end() ||
          std::ranges::adjacent_find(rows) != rows.end() || rows.size() + 2 >= faces_.size())
        continue;
      if (rows.size() > most) best = possible.size();
      most = std::max(most, rows.size());
      possible.push_back(v);
    }
    if (possible.empty()) return {0};
    std::vector<std::uint32_t> poles{possible[best]};
    // Of 63 spheres in the data set four need the second of these, one the third, one the seventh.
    constexpr double golden = 0.6180339887498949; // its multiples are spread evenly modulo 1
    for (double x = golden; poles.size() < 12; x += golden - (x + golden >= 1 ? 1 : 0))
      poles.push_back(possible[static_cast<std::size_t>(x * static_cast<double>(possible.size()))]);
    return poles;
  }

  // Gives all vertices the same curvature: then neighbours of the pole are nearly the right ones,
  // whatever the lambda lengths are scaled by. A tolerance of 1e-10 takes 3 % more
  // steps on the data set; with 1e-3 a sphere that is stretched by 100 is not found.
  void make_round() {
    const auto corners = static_cast<std::int64_t>(faces_.size() / 2 + 2); // of a sphere
    Prescribed_angles angles(base_.size());
    for (std::size_t v = 0; v < base_.size(); ++v)
      angles.set(v, Multiple_of_pi{2 * corners - 4, corners});
    solve(angles, 1e-6);
  }

  // The rows of neighbours of the pole, each once, in ascending order.
  std::vector<std::uint32_t> neighbours() const {
    std::vector<std::uint32_t> rows;
    for_each_at_pole([&](const Ideal_face& f, std::size_t k) {
      for (const std::size_t i : {1U, 2U})
        rows.push_back(static_cast<std::uint32_t>(f.rows[(k + i) % 3]));
    });
    std::ranges::sort(rows);
    rows.erase(std::unique(rows.begin(), rows.end()), rows.end());
    return rows;
  }

  template <class Function>
  void for_each_at_pole(const Function& function) const {
    for (const Ideal_face& f : faces_)
      for (std::size_t k = 0; k < 3; ++k)
        if (f.rows[k] == static_cast<int>(result_.pole)) function(f, k);
  }

  // Scales the neighbours such that they are at the same distance from the pole, and then the pole,
  // such that this is far: link edges look short from there, and edges to the pole are Delaunay.
  // \return whether there are neighbours to scale, and all factors are in range
  bool normalise(const std::vector<std::uint32_t>& fixed) {
    std::vector<char> is_fixed(base_.size(), 0);
    for (const std::uint32_t v : fixed) is_fixed[v] = 1;
    double first = 0;
    for_each_at_pole([&](const Ideal_face& f, std::size_t k) {
      const auto row = static_cast<std::size_t>(f.rows[(k + 1) % 3]);
      if (is_fixed[row] == 0) return;
      is_fixed[row] = 0;
      if (first == 0) first = f.lambda[k];
      base_[row] = base_[row] * (first / f.lambda[k]);
    });
    if (first == 0 || !surface_.scale(base_)) return false;
    surface_.read(faces_);
    double least = first, greatest = 0;
    for_each_at_pole([&](const Ideal_face& f, std::size_t k) {
      least = std::min(least, f.lambda[(k + 1) % 3]);
      greatest = std::max(greatest, f.lambda[(k + 1) % 3]);
    });
    // Rounding hides flips of edges to the pole if it is 5e7 times as far as link edges are long;
    // with 1e5 in place of 1e6 one sphere of the data set is not found, with 1e3 three are not.
    // From there all link edges are shorter than a milliradian, if they differ in length.
    base_[result_.pole] = base_[result_.pole] * (std::max(1e6 * least, 1e3 * greatest) / first);
    return are_in_range(base_);
  }

  void flatten(const std::vector<std::uint32_t>& fixed) {
    Prescribed_angles angles(base_.size());
    angles.set_free(result_.pole);
    for (const std::uint32_t v : fixed) angles.set_free(v);
    solve(angles, Conformal_options().tolerance);
  }

  void solve(const Prescribed_angles& angles, double tolerance) {
    Rescaled_surface rescaled(surface_, base_);
    Conformal_options options;
    options.tolerance = tolerance;
    options.progress = [](const Conformal_progress&) { return true; };
    const std::size_t flips = result_.metric.flips;
    const unsigned iterations = result_.metric.iterations;
    result_.metric = conformal_metric(rescaled, angles, options);
    result_.metric.flips += flips;
    result_.metric.iterations += iterations;
    const std::vector<Double_double> found = factors_of(result_.metric);
    for (std::size_t v = 0; v < base_.size(); ++v) {
      base_[v] = base_[v] * found[v];
      result_.metric.scale_factors[v] = base_[v].to_double();
      result_.metric.scale_rests[v] = rest(base_[v]);
      result_.metric.u[v] = 2 * std::log(base_[v].to_double());
    }
    surface_.read(faces_);
  }

  // Takes neighbours out at which the polygon without the pole has an angle over pi, but for the
  // residual: with 1e-12 or 1e-4 the same spheres of the data set are found.
  void remove_reflex(std::vector<std::uint32_t>& rows) const {
    std::vector<double> inner(base_.size(), 0);
    for (const Ideal_face& f : faces_)
      if (std::ranges::find(f.rows, static_cast<int>(result_.pole)) == f.rows.end())
        for (std::size_t k = 0; k < 3; ++k)
          inner[static_cast<std::size_t>(f.rows[k])] += angle_at(f, k);
    std::erase_if(rows, [&](std::uint32_t v) { return inner[v] > std::numbers::pi + 1e-7; });
  }

  Ideal_surface& surface_;
  std::vector<Double_double> base_; // factors of rows
  std::vector<Ideal_face> faces_;
  Punctured_sphere result_, start_; // the round surface
  std::vector<std::uint32_t> poles_;
};

// Takes a result to the sphere. Positions go by rows.
Conformal_sphere projected(const Ideal_surface& surface, Punctured_sphere found,
                           const Sphere_projector& project) {
  const std::vector<std::uint32_t>& row = surface.row_of_vertex();
  std::uint32_t pole_vertex = 0;
  std::vector<double> areas(row.size(), 0);
  for (std::uint32_t v = 0; v < row.size(); ++v) {
    if (row[v] == Gluing::none) continue;
    areas[v] = found.areas[row[v]];
    if (row[v] == found.pole) pole_vertex = v;
  }
  Conformal_sphere result{std::move(found.metric), project(pole_vertex, areas), found.rounds,
                          found.is_convex, Status::done};
  std::vector<std::array<double, 3>> by_row(surface.number_of_rows());
  for (std::uint32_t v = 0; v < row.size(); ++v)
    if (row[v] != Gluing::none) by_row[row[v]] = result.layout.positions[v];
  result.layout.positions = std::move(by_row);
  result.layout.pole = found.pole;
  const bool is_turned = result.metric.status == Status::done && result.layout.flipped_faces != 0;
  result.status = !result.is_convex ? Status::stalled
                  : is_turned       ? Status::inaccurate
                                    : result.metric.status;
  return result;
}

// The less, the better.
std::tuple<bool, std::size_t, bool> faults(const Conformal_sphere& s) {
  return {s.metric.status != Status::done, s.layout.flipped_faces, !s.is_convex};
}

// Tries poles until nothing is wrong, else takes the best one.
Conformal_sphere best_sphere(Ideal_surface& surface, Sphere_puncturer& puncturer,
                             const Sphere_projector& project) {
  std::optional<Conformal_sphere> best;
  std::optional<Invalid_input> refusal;
  for (const std::uint32_t pole : puncturer.poles()) {
    try {
      Conformal_sphere sphere = projected(surface, puncturer.run(pole), project);
      if (!best || faults(sphere) < faults(*best)) best = std::move(sphere);
      if (faults(*best) == std::tuple(false, std::size_t{0}, false)) return *std::move(best);
    } catch (const Invalid_input& e) { // no disk is left without this pole
      refusal = e;
    }
  }
  if (!best) throw *refusal;
  surface.scale(factors_of(best->metric));
  return *std::move(best);
}

} // namespace

Conformal_sphere conformal_sphere(Ideal_surface& surface, std::optional<std::uint32_t> pole,
                                  const Sphere_projector& project) {
  if (pole && *pole >= surface.number_of_rows())
    throw Invalid_input::about(Element_kind::vertex, *pole,
                               ", which is to be at infinity, does not exist");
  Sphere_puncturer puncturer(surface);
  if (pole) return projected(surface, puncturer.run(*pole), project);
  return best_sphere(surface, puncturer, project);
}

} // namespace CGAL::Intrinsic_triangulations::internal
