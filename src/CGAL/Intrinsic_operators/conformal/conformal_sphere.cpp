// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_operators/conformal/Ideal_surface.h>
#include <CGAL/Intrinsic_operators/conformal/Prescribed_angles.h>
#include <CGAL/Intrinsic_operators/conformal/conformal_metric.h>
#include <CGAL/Intrinsic_operators/conformal/conformal_sphere.h>
#include <CGAL/Intrinsic_triangulations/connectivity/Gluing.h>
#include <CGAL/Intrinsic_triangulations/connectivity/Invalid_input.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

namespace {

// A surface whose factors are those given times others.
class Rescaled_surface final : public Ideal_surface {
public:
  Rescaled_surface(Ideal_surface& surface, const std::vector<double>& base)
      : surface_(surface), base_(base) {}

  const std::vector<std::uint32_t>& row_of_vertex() const override {
    return surface_.row_of_vertex();
  }
  std::size_t number_of_rows() const override { return surface_.number_of_rows(); }
  std::uint32_t sheets() const override { return surface_.sheets(); }
  std::size_t scale(std::span<const double> factors) override {
    std::vector<double> product(base_);
    for (std::size_t i = 0; i < product.size(); ++i) product[i] *= factors[i];
    return surface_.scale(product);
  }
  void read(std::vector<Ideal_face>& faces) const override { surface_.read(faces); }
  std::optional<std::vector<Enclosed_ideal_face>> enclosures() const override {
    return surface_.enclosures();
  }

private:
  Ideal_surface& surface_;
  const std::vector<double>& base_;
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
  Sphere_puncturer(Ideal_surface& surface, std::optional<std::uint32_t> pole)
      : surface_(surface), base_(surface.number_of_rows(), 1) {
    surface_.scale(base_);
    surface_.read(faces_);
    if (pole && *pole >= base_.size())
      throw Invalid_input::about(Element_kind::vertex, *pole,
                                 ", which is to be at infinity, does not exist");
    result_.areas.assign(base_.size(), 0);
    for (const Ideal_face& f : faces_)
      for (const int row : f.rows) result_.areas[static_cast<std::size_t>(row)] += area_of(f) / 3;
    check_sphere();
    make_round();
    result_.pole = pole ? *pole : best_pole();
  }

  Punctured_sphere run() {
    std::vector<std::uint32_t> fixed = neighbours();
    // neighbours are right long before rounding ends the iteration
    while (result_.rounds < 20 && !result_.is_convex && result_.metric.residual < 1e-4) {
      const Punctured_sphere before = result_;
      ++result_.rounds;
      normalise(fixed);
      flatten(fixed);
      if (result_.rounds > 1 && !(result_.metric.residual < 1e-4)) return restored(before);
      std::vector<std::uint32_t> now = neighbours();
      remove_reflex(now);
      result_.is_convex = now == fixed;
      fixed = std::move(now);
    }
    return std::move(result_);
  }

private:
  // A round that found no metric is undone: the map before is one, though it is not convex.
  Punctured_sphere restored(const Punctured_sphere& before) {
    surface_.scale(before.metric.scale_factors);
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

  // The row with the most neighbours, if these are different.
  std::uint32_t best_pole() const {
    std::vector<std::vector<int>> around(base_.size());
    for (const Ideal_face& f : faces_)
      for (std::size_t k = 0; k < 3; ++k)
        around[static_cast<std::size_t>(f.rows[k])].push_back(f.rows[(k + 1) % 3]);
    std::size_t best = 0, most = 0;
    for (std::size_t v = 0; v < around.size(); ++v) {
      std::vector<int>& rows = around[v];
      std::ranges::sort(rows);
      if (rows.size() > most && std::ranges::find(rows, static_cast<int>(v)) == rows.end() &&
          std::ranges::adjacent_find(rows) == rows.end() && rows.size() + 2 < faces_.size()) {
        best = v;
        most = rows.size();
      }
    }
    return static_cast<std::uint32_t>(best);
  }

  // Gives all vertices the same curvature: then neighbours of the pole are nearly the right ones,
  // whatever the lambda lengths are scaled by.
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
    const auto [first, last] = std::ranges::unique(rows);
    rows.erase(first, last);
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
  void normalise(const std::vector<std::uint32_t>& fixed) {
    std::vector<char> is_fixed(base_.size(), 0);
    for (const std::uint32_t v : fixed) is_fixed[v] = 1;
    double first = 0;
    for_each_at_pole([&](const Ideal_face& f, std::size_t k) {
      const auto row = static_cast<std::size_t>(f.rows[(k + 1) % 3]);
      if (is_fixed[row] == 0) return;
      is_fixed[row] = 0;
      if (first == 0) first = f.lambda[k];
      base_[row] *= first / f.lambda[k];
    });
    surface_.scale(base_);
    surface_.read(faces_);
    double least = first, greatest = 0;
    for_each_at_pole([&](const Ideal_face& f, std::size_t k) {
      least = std::min(least, f.lambda[(k + 1) % 3]);
      greatest = std::max(greatest, f.lambda[(k + 1) % 3]);
    });
    // rounding hides flips of edges to the pole if it is 5e7 times as far as link edges are long
    base_[result_.pole] *= std::max(1e6 * least, 1e3 * greatest) / first;
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
    for (std::size_t v = 0; v < base_.size(); ++v) {
      base_[v] *= result_.metric.scale_factors[v];
      result_.metric.u[v] = 2 * std::log(base_[v]);
    }
    result_.metric.scale_factors = base_;
    surface_.read(faces_);
  }

  // Takes neighbours out at which the polygon without the pole has an angle over pi.
  void remove_reflex(std::vector<std::uint32_t>& rows) const {
    std::vector<double> inner(base_.size(), 0);
    for (const Ideal_face& f : faces_)
      if (std::ranges::find(f.rows, static_cast<int>(result_.pole)) == f.rows.end())
        for (std::size_t k = 0; k < 3; ++k)
          inner[static_cast<std::size_t>(f.rows[k])] += angle_at(f, k);
    std::erase_if(rows, [&](std::uint32_t v) { return inner[v] > std::numbers::pi + 1e-7; });
  }

  Ideal_surface& surface_;
  std::vector<double> base_; // factors of rows
  std::vector<Ideal_face> faces_;
  Punctured_sphere result_;
};

} // namespace

Punctured_sphere punctured_sphere(Ideal_surface& surface, std::optional<std::uint32_t> pole) {
  return Sphere_puncturer(surface, pole).run();
}

} // namespace CGAL::Intrinsic_triangulations::internal
