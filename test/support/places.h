// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef TEST_INTRINSIC_TRIANGULATIONS_PLACES_H
#define TEST_INTRINSIC_TRIANGULATIONS_PLACES_H

#include <CGAL/Intrinsic_triangulations/correspondence/Intrinsic_view.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/Diamond_unfolder.h>
#include <CGAL/Intrinsic_triangulations/exact/Exact_ladder.h>
#include <CGAL/Intrinsic_triangulations/exact/numbers/Multiquadratic_number.h>
#include <CGAL/Intrinsic_triangulations/exact/unfolding/figures.h>
#include <CGAL/Intrinsic_triangulations/formulas/Face_values.h>
#include <CGAL/Intrinsic_triangulations/input/Input_metric.h>
#include <CGAL/Intrinsic_triangulations/triangulation/Surface_point.h>

#include <CGAL/Gmpq.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <span>
#include <unordered_map>
#include <utility>
#include <vector>

// The exact meaning of vertices that are places on the input.

namespace places {

namespace IT = CGAL::Intrinsic_triangulations;
using CGAL::Gmpq;
using IT::Multiquadratic_number;

/// A point of the plane.
using Position = std::array<Gmpq, 2>;

/// Whether a place can define a vertex: weights are multiples of 2^-52 that sum to 1, and not those
/// of a corner.
inline bool is_exact(const IT::Surface_point& p) {
  Gmpq sum(0);
  for (const double w : p.weights) {
    if (!(w >= 0 && w < 1) || w * 0x1p52 != std::floor(w * 0x1p52)) return false;
    sum += Gmpq(w);
  }
  return sum == Gmpq(1);
}

/// The combination of the corners of a face, from a halfedge on.
template <class Connectivity>
Position combination(const Connectivity& mesh, std::uint32_t h,
                     const std::array<double, 3>& weights, const std::vector<Position>& at) {
  Position p{Gmpq(0), Gmpq(0)};
  for (const double w : weights) {
    const Position& q = at[mesh.source(h)];
    for (std::size_t k = 0; k < 2; ++k) p[k] += Gmpq(w) * q[k];
    h = mesh.next(h);
  }
  return p;
}

/// The largest coordinate of a difference.
inline double distance(const Position& p, const Position& q) {
  return std::max(std::abs(CGAL::to_double(Gmpq(p[0] - q[0]))),
                  std::abs(CGAL::to_double(Gmpq(p[1] - q[1]))));
}

/// Input faces with exact areas, to evaluate unfolded faces.
class Exact_input {
public:
  using Face = std::pair<std::array<Multiquadratic_number, 3>, Multiquadratic_number>;

  explicit Exact_input(const IT::Input_metric& input) : input_(&input) {}
  const Face& operator()(std::uint32_t f) const {
    const auto found = faces_.find(f);
    if (found != faces_.end()) return found->second;
    const auto root = basis_.sqrt_of(input_->squared_quadruple_area<Gmpq>(f));
    return faces_
        .emplace(f, Face{{Multiquadratic_number(input_->squared_length<Gmpq>(f, 0)),
                          Multiquadratic_number(input_->squared_length<Gmpq>(f, 1)),
                          Multiquadratic_number(input_->squared_length<Gmpq>(f, 2))},
                         Multiquadratic_number(basis_, root.value())})
        .first->second;
  }

private:
  const IT::Input_metric* input_;
  mutable IT::Square_class_basis basis_;
  mutable std::unordered_map<std::uint32_t, Face> faces_;
};

/// Values of a triangulation with integer coordinates, from these and the input alone.
template <class T>
class Unfolded {
public:
  using Face = IT::Face_values<CGAL::Interval_nt<false>>;

  explicit Unfolded(const T& t) : t_(&t), view_(t) {}

  const IT::Unfolded_diamond& face(std::uint32_t h) {
    return unfolder_.face(view_, t_->correspondence(), h);
  }
  const IT::Unfolded_diamond& diamond(std::uint32_t h) {
    return unfolder_(view_, t_->correspondence(), h);
  }
  const IT::Unfolded_diamond& wedge(std::span<const IT::Indexed_face> faces) {
    return unfolder_.wedge(view_, t_->correspondence(), faces);
  }

  /// Intervals in many bits, rounded to doubles, from a halfedge on; rounding must be upwards.
  Face enclosure(std::uint32_t h, unsigned bits = 256) {
    return ladder_.enclosures(t_->input().metric(), IT::Unfolded_faces{{face(h)}}, bits).front();
  }

  /// Exact values, from a halfedge on.
  IT::Face_values<Multiquadratic_number> exact(std::uint32_t h, const Exact_input& input) {
    const auto v = face(h).template values<Multiquadratic_number>(input);
    return {{v.ij, v.jk, v.ki}, v.area_f};
  }

private:
  const T* t_;
  IT::Intrinsic_view<T> view_;
  IT::Diamond_unfolder unfolder_;
  IT::Exact_ladder ladder_;
};

/// A halfedge of each face, by number.
template <class T>
std::vector<std::uint32_t> halfedges_of_faces(const T& t) {
  const IT::Intrinsic_view<T> view(t);
  std::vector<std::uint32_t> result;
  for (const auto f : faces(t.mesh())) result.push_back(view.halfedge_of_face(t.index(f)));
  return result;
}

/// The first halfedge of a face with a stored interval, or double beside it, that does not fit the
/// places, or without a proof that the face is positive; none if there is no such face.
template <class T>
std::uint32_t first_wrong_value(const T& t) {
  const CGAL::Protect_FPU_rounding<true> upwards;
  const IT::Intrinsic_view<T> view(t);
  Unfolded<T> unfolded(t);
  const auto contains = [](const CGAL::Interval_nt<false>& stored, double near,
                           const CGAL::Interval_nt<false>& exact) {
    return stored.inf() <= exact.sup() && exact.inf() <= stored.sup() && stored.inf() <= near &&
           near <= stored.sup();
  };
  const auto& m = t.metric();
  for (std::uint32_t h : halfedges_of_faces(t)) {
    const std::uint32_t f = view.face(h);
    for (unsigned k = 0; k < 3; ++k, h = view.next(h)) { // from each side, along another path
      const auto exact = unfolded.enclosure(h);
      const std::uint32_t e = h / 2;
      if (!contains(m.squared_length(e), m.approximate_squared_length(e),
                    exact.squared_lengths[0]) ||
          !contains(m.quadruple_area(f), m.approximate_quadruple_area(f), exact.quadruple_area) ||
          !(exact.quadruple_area.inf() > 0))
        return h;
    }
  }
  return IT::Gluing::none;
}

} // namespace places

#endif // TEST_INTRINSIC_TRIANGULATIONS_PLACES_H
