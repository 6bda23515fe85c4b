// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_MODELS_VERTEX_PLACES_H
#define CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_MODELS_VERTEX_PLACES_H

#include <CGAL/Intrinsic_triangulations/connectivity/Gluing.h>
#include <CGAL/Intrinsic_triangulations/connectivity/Gluing_map.h>
#include <CGAL/Intrinsic_triangulations/connectivity/as_gluing.h>
#include <CGAL/Intrinsic_triangulations/connectivity/graph_traits_Gluing_map.h>
#include <CGAL/Intrinsic_triangulations/correspondence/Intrinsic_view.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/Diamond_unfolder.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/Integer_coordinates.h>
#include <CGAL/Intrinsic_triangulations/exact/unfolding/Flip_history.h>
#include <CGAL/Intrinsic_triangulations/exact/unfolding/Input_unfolder.h>
#include <CGAL/Intrinsic_triangulations/exact/unfolding/Unfolded_diamond.h>
#include <CGAL/Intrinsic_triangulations/formulas/Diamond.h>
#include <CGAL/Intrinsic_triangulations/input/Input.h>
#include <CGAL/Intrinsic_triangulations/metric/Exact_euclidean_traits.h>
#include <CGAL/Intrinsic_triangulations/triangulation/Mover.h>
#include <CGAL/Intrinsic_triangulations/triangulation/Moves.h>

#include <CGAL/boost/graph/Euler_operations.h>

#include <concepts>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// Unfolds the input under an intrinsic triangulation by its integer coordinates.
template <class Triangulation>
class Triangulation_unfolder final : public Input_unfolder {
public:
  Triangulation_unfolder(const Triangulation& t, const Integer_coordinates& coordinates)
      : view_(t), coordinates_(coordinates) {}

  const Unfolded_diamond& diamond(const Diamond& d) override {
    return unfolder_(view_, coordinates_, halfedge(d.ij, d.f));
  }
  const Unfolded_diamond& face(const Indexed_face& f) override {
    return unfolder_.face(view_, coordinates_, halfedge(f.edges[0], f.face));
  }

private:
  std::uint32_t halfedge(std::uint32_t edge, std::uint32_t face) const {
    return view_.face(2 * edge) == face ? 2 * edge : 2 * edge + 1;
  }

  Intrinsic_view<Triangulation> view_;
  const Integer_coordinates& coordinates_;
  Diamond_unfolder unfolder_;
};

// A triangulation in the order of its flips, so far as coordinates observe it.
class Replayed_flips {
public:
  // undoes the flips of a history
  Replayed_flips(Gluing_map mesh, const Exact_euclidean_metric& metric)
      : mesh_(std::move(mesh)), number_(mesh_) {
    const Flip_history& history = metric.history();
    const std::uint32_t faces = mesh_.number_of_faces();
    std::vector<Made> made(faces + 2 * std::size_t{history.number_of_flips()});
    for (std::uint32_t f = 0; f < faces; ++f) {
      const auto& [version, edge] = metric.version(f);
      made[version] = {f, edge};
    }
    for (std::uint32_t n = history.number_of_flips(); n-- > 0;) {
      const std::uint32_t version = history.left_version(n);
      const Made left = made[version], right = made[version + 1];
      const Gluing_map::Halfedge h = halfedge(left);
      flipped_.push_back(h.index);
      for (unsigned k = 0; k < 3; ++k) CGAL::Euler::flip_edge(h, mesh_); // the fourth power is 1
      made[history.left_parent(n).face] = parent(history.left_parent(n), left.face, h);
      made[history.right_parent(n).face] =
          parent(history.right_parent(n), right.face, Gluing_map::Halfedge{h.index ^ 1U});
    }
    for (std::uint32_t f = 0; f < faces; ++f) // slot 0 of an input face is its first side
      mesh_.set_halfedge(Gluing_map::Face{made[f].face}, halfedge(made[f]));
    choose_halfedges_of_vertices();
  }

  // the connectivity before them
  const Gluing_map& mesh() const { return mesh_; }

  // makes them again, and lets coordinates follow
  void replay(Integer_coordinates& coordinates) {
    for (; !flipped_.empty(); flipped_.pop_back()) {
      const Gluing_map::Halfedge h{flipped_.back()};
      const Flip move = flip_record(h, mesh_, number_);
      coordinates.before(*this, move);
      CGAL::Euler::flip_edge(h, mesh_);
      coordinates.after(*this, move);
    }
  }

private:
  // a face, and the edge in slot 0
  struct Made {
    std::uint32_t face, edge;
  };

  Gluing_map::Halfedge halfedge(const Made& m) const {
    const Gluing_map::Halfedge h{2 * m.edge};
    return mesh_.face(h).index == m.face ? h : Gluing_map::Halfedge{2 * m.edge + 1};
  }

  // whatever flips did
  void choose_halfedges_of_vertices() {
    for (std::uint32_t f = 0; f < mesh_.number_of_faces(); ++f)
      for (const Gluing_map::Halfedge h : mesh_.sides({f})) mesh_.set_halfedge(mesh_.target(h), h);
    for (std::uint32_t h = 0; h < mesh_.number_of_halfedges(); ++h)
      if (mesh_.face({h}).index == Gluing::none) mesh_.set_halfedge(mesh_.target({h}), {h});
  }

  // of the side that is halfedge h
  Made parent(const Flip_history::Side& side, std::uint32_t face, Gluing_map::Halfedge h) const {
    for (std::uint32_t slot = side.slot; slot % 3 != 0; ++slot) h = mesh_.next(h);
    return {face, h.index / 2};
  }

  Gluing_map mesh_;
  Mesh_adaptor<Gluing_map> number_;
  std::vector<std::uint32_t> flipped_; // halfedges, the last flip first
};

// Knows where the vertices of a triangulation are on the input, from the first insertion on, for a metric that they
// define: by the correspondence, if that has integer coordinates on the input, else by coordinates of its own.
template <class Triangulation>
class Vertex_places {
  using Correspondence = typename Triangulation::Correspondence;

public:
  Vertex_places() = default;
  // the copy must be attached to its triangulation
  Vertex_places(const Vertex_places& other)
      : own_(other.own_ ? std::make_unique<Integer_coordinates>(*other.own_) : nullptr),
        has_started_(other.has_started_) {}
  Vertex_places(Vertex_places&&) = default;
  Vertex_places& operator=(Vertex_places&&) = default;

  // to be called before the first insertion; `metric` is that of the triangulation
  void start(const Triangulation& t, Exact_euclidean_metric& metric) {
    if (has_started_) return;
    has_started_ = true;
    if (!is_shared(t)) own_ = std::make_unique<Integer_coordinates>(replayed(t));
    attach(t, metric);
  }

  // instead of `start()`, in a triangulation that is restored: takes coordinates, which its correspondence has too if
  // it can
  void restore(const Triangulation& t, Exact_euclidean_metric& metric,
               const Integer_coordinates& coordinates) {
    has_started_ = true;
    if (!is_shared(t)) own_ = std::make_unique<Integer_coordinates>(coordinates);
    attach(t, metric);
  }

  // the coordinates that are kept, if there are any
  const Integer_coordinates* kept(const Triangulation& t) const {
    return has_started_ || is_shared(t) ? &coordinates(t) : nullptr;
  }

  // coordinates that follow the history of flips
  static Integer_coordinates replayed(const Triangulation& t) {
    Replayed_flips flips(numbered_copy(t.mesh(), t.numbers()), t.metric());
    Integer_coordinates result;
    result.start(Started{surface_of(t, flips.mesh())});
    flips.replay(result);
    return result;
  }

  // to be called when the triangulation has got another address
  void attach(const Triangulation& t, Exact_euclidean_metric& metric) {
    if (!has_started_) return;
    unfolder_ = std::make_unique<Triangulation_unfolder<Triangulation>>(t, coordinates(t));
    metric.define_by_places(*unfolder_);
  }

  // the values at the vertex whose insertion was announced last
  const auto& inserted_values(const Triangulation& t) const {
    return coordinates(t).inserted_values();
  }

  // observes moves like a correspondence
  template <class Move>
  bool before(const Triangulation& t, const Move& move) {
    return !own_ || own_->before(t, move);
  }
  template <class Move>
  void after(const Triangulation& t, const Move& move) {
    if (own_) own_->after(t, move);
  }

private:
  struct Started {
    std::shared_ptr<const Input> input;
    const std::shared_ptr<const Input>& shared_input() const { return input; }
  };

  static bool is_shared(const Triangulation& t) {
    return std::derived_from<Correspondence, Integer_coordinates> &&
           t.input().is_defined_by_metric();
  }

  const Integer_coordinates& coordinates(const Triangulation& t) const {
    if constexpr (std::derived_from<Correspondence, Integer_coordinates>)
      if (!own_) return t.correspondence();
    return *own_;
  }

  // the input of a triangulation, with connectivity, lengths and areas
  static std::shared_ptr<const Input> surface_of(const Triangulation& t, const Gluing_map& mesh) {
    if (t.input().has_surface() && t.input().is_defined_by_metric()) return t.shared_input();
    auto input = std::make_shared<Input>(mesh, t.input().metric(), t.input().names());
    input->keep_values(Exact_euclidean_metric(input));
    return input;
  }

  std::unique_ptr<Integer_coordinates> own_;
  std::unique_ptr<Triangulation_unfolder<Triangulation>> unfolder_;
  bool has_started_ = false;
};

// Other metrics are defined by moves.
template <class Triangulation>
struct No_vertex_places {
  template <class Metric>
  void start(const Triangulation&, Metric&) {}
  template <class Metric>
  void restore(const Triangulation&, Metric&, const Integer_coordinates&) {}
  template <class Metric>
  void attach(const Triangulation&, Metric&) {}
  template <class Move>
  bool before(const Triangulation&, const Move&) {
    return true;
  }
  template <class Move>
  void after(const Triangulation&, const Move&) {}
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_MODELS_VERTEX_PLACES_H
