// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_RETRIANGULATION_OPTIMIZATION_ODT_OPTIMIZER_H
#define CGAL_INTRINSIC_TRIANGULATIONS_RETRIANGULATION_OPTIMIZATION_ODT_OPTIMIZER_H

#include <CGAL/Intrinsic_triangulations/connectivity/Gluing.h>
#include <CGAL/Intrinsic_triangulations/correspondence/Intrinsic_view.h>
#include <CGAL/Intrinsic_triangulations/formulas/Diamond.h>
#include <CGAL/Intrinsic_triangulations/formulas/Face_values.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/delaunay/Delaunay_flipper.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/delaunay/measure_quality.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/optimization/Planar_star.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/refinement/Refinement_result.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/refinement/Surface_check.h>
#include <CGAL/Intrinsic_triangulations/support/Status.h>
#include <CGAL/Intrinsic_triangulations/support/caps.h>
#include <CGAL/Intrinsic_triangulations/support/cmath.h>
#include <CGAL/Intrinsic_triangulations/support/parameters.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <stdexcept>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/*!
\brief reports what the optimisation did.
*/
struct Odt_result {
  /// `done`: no edge is too long, and the energy hardly changes; `cap`: the cap on iterations,
  /// insertions or, with inexact numbers, flips was reached; `cancelled`; or `inaccurate`: do not
  /// use the triangulation.
  Status status = Status::cap;
  /// Iterations done.
  unsigned iterations = 0;
  /// Edges split.
  std::uint64_t splits = 0;
  /// Vertices moved, those of all iterations together.
  std::uint64_t moves = 0;
  /// Moves and splits that the triangulation refused.
  std::uint64_t refused = 0;
  /// Edges flipped to keep the triangulation Delaunay, those of moves not counted.
  std::uint64_t flips = 0;
  /// The energy before, see `odt_energy()`, in the units of the input to the fourth power.
  double energy_before = 0;
  /// The energy after.
  double energy_after = 0;
  /// Vertices inserted in the end, for the least angle.
  std::uint64_t insertions = 0;
  /// The least angle of all faces in the end, in degrees, rounded.
  double minimum_angle = 0;
  /// Number of faces with an angle below the bound: `delaunay_refine()` would list them.
  std::size_t unsatisfied_faces = 0;
  /// Damage by rounding, if it is `inaccurate`.
  std::optional<Inaccuracy> inaccuracy = std::nullopt;
};

/*!
\brief observes the optimisation; the default visitor does nothing.
*/
struct Odt_visitor {
  /*!
  \brief is called after every iteration, and about every 256 moves, but not during the refinement
  that may follow.
  \return whether to go on
  */
  bool progress(const Odt_result&) { return true; }
};

namespace internal {

/*!
Splits long edges and moves inserted vertices so that the energy of `odt_energy()` falls (§4.5 of
the course).

For fixed faces around a vertex, the energy is a quadratic polynomial of its position: every step
towards the optimum lowers it, as long as all sides of the star stay visible. Splits and Delaunay
flips lower it, too: with exact numbers the energy never rises.
*/
template <class Triangulation>
class Odt_optimizer {
  using Mesh = typename Triangulation::Mesh;
  using Traits = boost::graph_traits<Mesh>;
  using Session = typename Triangulation::Session;
  using Vertex = typename Triangulation::vertex_descriptor;
  using Halfedge = typename Triangulation::halfedge_descriptor;

public:
  /// takes the named parameters of `odt_optimize()`, and what asks its visitor to go on.
  template <class NP>
  Odt_optimizer(Triangulation& t, const NP& np, std::function<bool(const Odt_result&)> progress)
      : t_(t), mesh_(t.mesh()), session_(t), view_(t), progress_(std::move(progress)),
        flipper_(t, session_),
        number_of_iterations_(value_or<tags::number_of_iterations>(np, 100U)),
        convergence_(value_or<tags::convergence>(np, 1e-3)),
        cap_(value_or<tags::maximum_insertions>(np, std::optional<std::uint64_t>())
                 .value_or(insertion_cap(num_faces(t.mesh())))) {
    const double length =
        value_or<tags::maximum_edge_length>(np, std::numeric_limits<double>::infinity());
    if (!(length > 0)) throw std::invalid_argument("the largest length of edges must be positive");
    squared_target_ = std::ldexp(length * length, 2 * t.metric().scale_exponent());
  }

  /// optimises; edges in `constrained` are kept.
  template <class Constrained>
  Odt_result run(const Constrained& constrained) {
    for (const auto e : edges(mesh_)) {
      const Halfedge h = halfedge(e, mesh_);
      if (get(constrained, e)) set_whole(number(h) / 2, number(h) / 2);
      flipper_.push(h);
    }
    result_.energy_before = odt_energy(t_);
    is_going_on_ = flipper_.run(*this);
    double energy = odt_energy(t_);
    while (is_going_on_ && result_.iterations < number_of_iterations_) {
      ++result_.iterations;
      const std::uint64_t splits = result_.splits;
      if (!split_long_edges() || !move_vertices() || !flip_everywhere()) break;
      fit_areas_to_sides();
      const double after = odt_energy(t_);
      const bool is_steady = after > (1 - convergence_) * energy;
      energy = after;
      if (!may_go_on()) break;
      if (splits != result_.splits || !is_steady) continue;
      result_.status = Status::done;
      break;
    }
    result_.energy_after = odt_energy(t_);
    return result_;
  }

  /// returns the constrained edge that an edge is, or is a part of, or `Gluing::none`.
  std::uint32_t whole(std::uint32_t e) const {
    return e < whole_.size() ? whole_[e] : Gluing::none;
  }

  // ---- observer of the flipper
  bool before_check() { return true; }
  bool before_flip() {
    const std::uint64_t cap = flip_cap(num_edges(mesh_) + result_.splits + result_.moves);
    if (Triangulation::Metric::is_exact || result_.flips < cap) return true;
    is_going_on_ = false;
    return false;
  }
  bool is_constrained(Halfedge h) const { return whole(number(h) / 2) != Gluing::none; }
  void after_flip(Halfedge) { ++result_.flips; }
  void refused(Halfedge) { ++result_.refused; }

private:
  std::uint32_t number(Halfedge h) const { return t_.numbers().halfedge(h); }
  Halfedge descriptor(std::uint32_t h) const { return t_.numbers().halfedge_at(h); }
  bool is_border(Halfedge h) const { return face(h, mesh_) == Traits::null_face(); }

  void set_whole(std::uint32_t e, std::uint32_t whole) {
    if (e >= whole_.size()) whole_.resize(e + std::size_t{1}, Gluing::none);
    whole_[e] = whole;
  }

  bool may_go_on() {
    if (!session_.suspended([this] { return progress_(result_); })) {
      result_.status = Status::cancelled;
      is_going_on_ = false;
    }
    return is_going_on_;
  }

  // ---- splits

  // those that are too long now, the longest first; the parts come next time
  bool split_long_edges() {
    std::vector<std::pair<double, std::uint32_t>> longest;
    for (const auto e : edges(mesh_)) {
      const std::uint32_t h = number(halfedge(e, mesh_));
      const double length = view_.squared_length(h / 2);
      if (length > squared_target_) longest.push_back({length, h});
    }
    std::sort(longest.begin(), longest.end(), [](const auto& a, const auto& b) {
      return a.first != b.first ? a.first > b.first : a.second < b.second;
    });
    for (const auto& [length, h] : longest) {
      if (result_.splits >= cap_) return false;
      // flips near other splits may have made it shorter
      if (view_.squared_length(h / 2) > squared_target_ && !split(descriptor(h))) return false;
    }
    return true;
  }

  bool split(Halfedge h) {
    if (is_border(h)) h = opposite(h, mesh_);
    const std::uint32_t e = number(h) / 2, whole_edge = whole(e);
    const bool on_border = is_border(opposite(h, mesh_));
    const auto n = session_.split_edge(h, 0.5);
    if (n.status != Move_status::done) {
      ++result_.refused;
      return true;
    }
    ++result_.splits;
    if (whole_edge != Gluing::none) {
      // on the border h is the first half; inside it was flipped, and runs from the vertex
      set_whole(e, Gluing::none);
      const Halfedge one = on_border ? h : next(next(h, mesh_), mesh_);
      const Halfedge other = on_border ? next(opposite(next(h, mesh_), mesh_), mesh_)
                                       : next(opposite(h, mesh_), mesh_);
      set_whole(number(one) / 2, whole_edge);
      set_whole(number(other) / 2, whole_edge);
    }
    flipper_.push_star(n.vertex);
    return flipper_.run(*this);
  }

  // ---- moves

  bool move_vertices() {
    std::vector<Vertex> inserted; // moving a vertex makes a new one
    for (const Vertex v : vertices(mesh_))
      if (t_.is_inserted(v)) inserted.push_back(v);
    for (const Vertex v : inserted) {
      move(v);
      if ((result_.moves & 0xffU) == 0xffU && !may_go_on()) return false;
      if (!is_going_on_) return false;
    }
    return true;
  }

  // a vertex on the border or on a constrained edge stays
  bool may_move(Vertex v) {
    if (!star_.load(view_, number(opposite(halfedge(v, mesh_), mesh_)))) return false;
    return std::none_of(star_.spokes().begin(), star_.spokes().end(),
                        [this](std::uint32_t h) { return whole(h / 2) != Gluing::none; });
  }

  void move(Vertex v) {
    if (!may_move(v)) return;
    const std::optional<Surface_point> place = next_place();
    if (!place) return;
    rim_.clear();
    for (const std::uint32_t h : star_.spokes()) rim_.push_back(next(descriptor(h), mesh_));
    const auto n = session_.reposition_vertex(v, descriptor(place->halfedge), place->weights);
    for (const Halfedge h : rim_) flipper_.push(h);
    if (n.status == Move_status::done) {
      ++result_.moves;
      flipper_.push_star(n.vertex);
    } else
      ++result_.refused;
    flipper_.run(*this);
  }

  // The optimum, or a point on the way there that leaves some space to the rim; nothing if the
  // vertex would hardly move.
  std::optional<Surface_point> next_place() const {
    Plane_vector<double> p = star_.optimum();
    const double space = least_space * star_.clearance({0, 0});
    if (!(space > 0)) return std::nullopt;
    for (int halvings = 0; halvings < maximum_halvings; ++halvings) {
      if (!(std::hypot(p[0], p[1]) > least_step * space)) return std::nullopt;
      if (star_.clearance(p) >= space) return star_.locate(p);
      p = p / 2;
    }
    return std::nullopt;
  }

  // flips inside the rims of moved vertices may have been missed
  bool flip_everywhere() {
    for (const auto e : edges(mesh_)) flipper_.push(halfedge(e, mesh_));
    return flipper_.run(*this);
  }

  // ---- with floating point numbers

  // Areas and lengths are stored separately. Thousands of moves in one place let areas drift by per
  // cents of a face, lengths far less, since a removal finds a straight angle to seven digits. So
  // areas are recomputed from lengths from time to time, except those of thin faces, where digits
  // would cancel.
  void fit_areas_to_sides() {
    if constexpr (requires(Halfedge h, Flipped_values<double> n) { session_.correct_values(h, n); })
      for (const auto e : edges(mesh_)) {
        const Halfedge h = halfedge(e, mesh_), o = opposite(h, mesh_);
        if (is_border(h) || is_border(o) || face(h, mesh_) == face(o, mesh_)) continue;
        const Face_values<double> f = fitted(h), g = fitted(o);
        session_.correct_values(h, {f.squared_lengths[0], f.quadruple_area, g.quadruple_area});
      }
  }

  // the values of the face of a halfedge, its side first
  Face_values<double> fitted(Halfedge h) const {
    const Halfedge n = next(h, mesh_), l = next(n, mesh_);
    Face_values<double> v{{view_.squared_length(number(h) / 2), view_.squared_length(number(n) / 2),
                           view_.squared_length(number(l) / 2)},
                          view_.quadruple_area(t_.index(face(h, mesh_)))};
    const double spanned = spanned_area(v);
    if (spanned > least_spanned && area_discrepancy(v) > doubtful_discrepancy) {
      const auto& s = v.squared_lengths;
      v.quadruple_area = std::max({s[0], s[1], s[2]}) * std::sqrt(spanned);
    }
    return v;
  }

  // of faces that are not thin: higher than 1/32 of their longest sides; beyond rounding, which
  // cancelled digits make as many times larger
  static constexpr double least_spanned = 0x1p-8;
  static constexpr double doubtful_discrepancy = 0x1p-52 / least_spanned;

  // Space to the rim that a step leaves, relative to the space before. The space changes by no more
  // than the vertex moves: optima up to 384 such spaces away come within three of them after eight
  // tries, where there is room.
  static constexpr double least_space = 0.25;
  static constexpr int maximum_halvings = 8;
  // The shortest step, in these spaces. The energy of a star is quadratic in the place of its
  // vertex: what such a step gains is below a millionth of what a step of a space does.
  static constexpr double least_step = 1e-3;

  Triangulation& t_;
  const Mesh& mesh_;
  Session session_;
  Intrinsic_view<Triangulation> view_;
  std::function<bool(const Odt_result&)> progress_;
  Delaunay_flipper<Triangulation> flipper_;
  unsigned number_of_iterations_;
  double convergence_, squared_target_;
  std::uint64_t cap_;
  Planar_star star_;
  std::vector<Halfedge> rim_;
  std::vector<std::uint32_t> whole_; // by edge number
  bool is_going_on_ = true;
  Odt_result result_;
};

} // namespace internal

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_RETRIANGULATION_OPTIMIZATION_ODT_OPTIMIZER_H
