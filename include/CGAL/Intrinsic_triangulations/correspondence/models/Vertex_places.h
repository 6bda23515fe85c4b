// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_MODELS_VERTEX_PLACES_H
#define CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_MODELS_VERTEX_PLACES_H

#include <CGAL/Intrinsic_triangulations/connectivity/Gluing_map.h>
#include <CGAL/Intrinsic_triangulations/connectivity/as_gluing.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/Integer_coordinates.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/No_correspondence.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/Replayed_flips.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/Triangulation_unfolder.h>
#include <CGAL/Intrinsic_triangulations/input/Input.h>
#include <CGAL/Intrinsic_triangulations/metric/Exact_euclidean_traits.h>
#include <CGAL/Intrinsic_triangulations/triangulation/Moves.h>

#include <concepts>
#include <memory>
#include <optional>
#include <type_traits>

namespace CGAL::Intrinsic_triangulations::internal {

// What integer coordinates restore.
template <class Correspondence>
concept Restorable = std::is_same_v<Correspondence, No_correspondence> ||
    std::is_base_of_v<Integer_coordinates, Correspondence>;

// Knows where the vertices and edges of a triangulation are on the input, for a metric that is exact: by the
// correspondence, if that has integer coordinates on the input, else by coordinates of its own. These are made from
// the history of flips when they are first asked for, and follow all moves from then on. From the first insertion on
// they define the vertices.
template <class Triangulation>
class Vertex_places {
  using Correspondence = typename Triangulation::Correspondence;
  using Unfolder = Triangulation_unfolder<Triangulation, Vertex_places>;

public:
  Vertex_places() = default;
  // the copy must be attached to its triangulation
  Vertex_places(const Vertex_places& other);
  Vertex_places(Vertex_places&& other) noexcept;
  Vertex_places& operator=(Vertex_places&& other) noexcept;
  ~Vertex_places();

  // to be called when the triangulation is complete, and when it has got another address; `metric` is its metric
  void attach(const Triangulation& t, Exact_euclidean_metric& metric);

  // takes the coordinates of a triangulation that is restored, which its correspondence has too if it can
  void restore(const Triangulation& t, Exact_euclidean_metric& metric,
               const Integer_coordinates& coordinates) {
    state_ = is_shared(t) ? State::shared : State::own;
    if (state_ == State::own) own_ = std::make_unique<Integer_coordinates>(coordinates);
    attach(t, metric);
    define(t, metric);
  }

  // to be called before an insertion; whether there are coordinates
  bool define(const Triangulation& t, Exact_euclidean_metric& metric) {
    if (define_metric_) return true;
    define_metric_ = coordinates(t) != nullptr;
    if (define_metric_) metric.forget_flips();
    return define_metric_;
  }

  // whether values are defined by places, not by the history of flips
  bool define_metric() const { return define_metric_; }

  // the coordinates; null if an edge crosses more input edges than they can count
  const Integer_coordinates* coordinates(const Triangulation& t) const {
    if (state_ == State::unknown) start(t);
    if constexpr (std::derived_from<Correspondence, Integer_coordinates>)
      if (state_ == State::shared) return &t.correspondence();
    return own_.get();
  }

  // the same, if they are about the input of the triangulation and that has its surface
  const Integer_coordinates* on_input(const Triangulation& t) const {
    if (!are_on_input_) // linear: not to be found at every insertion
      are_on_input_ = t.input().has_surface() && t.input().is_defined_by_metric();
    return *are_on_input_ ? coordinates(t) : nullptr;
  }

  // the values at the vertex whose insertion was announced last
  const auto& inserted_values(const Triangulation& t) const {
    return coordinates(t)->inserted_values();
  }

  // observes moves like a correspondence
  template <class Move>
  bool before(const Triangulation& t, const Move& move) {
    if (!own_ || own_->before(t, move)) return true;
    if (!std::same_as<Move, Flip> || define_metric_) return false;
    own_.reset(); // the flip is not to be refused: from now on the history tells all
    state_ = State::impossible;
    return true;
  }
  template <class Move>
  void after(const Triangulation& t, const Move& move) {
    if (state_ == State::unknown) return; // nothing has been unfolded
    if (own_) own_->after(t, move);
    unfolder_->after(move);
  }

private:
  enum class State { unknown, shared, own, impossible };

  struct Started {
    std::shared_ptr<const Input> input;
    const std::shared_ptr<const Input>& shared_input() const { return input; }
  };

  static bool is_shared(const Triangulation& t) {
    return std::derived_from<Correspondence, Integer_coordinates> &&
           t.input().is_defined_by_metric();
  }

  void start(const Triangulation& t) const;

  // by numbers; before the first insertion those of a gluing map have no gaps
  static Gluing_map connectivity_of(const Triangulation& t) {
    if constexpr (std::is_same_v<typename Triangulation::Mesh, Gluing_map>)
      return t.mesh();
    else
      return numbered_copy(t.mesh(), t.numbers());
  }

  // the input of a triangulation, with connectivity
  static std::shared_ptr<const Input> surface_of(const Triangulation& t, const Gluing_map& mesh);

  // mutable: a cache of what the history tells, until they define the metric
  mutable std::unique_ptr<Integer_coordinates> own_;
  mutable State state_ = State::unknown;
  mutable std::optional<bool> are_on_input_; // unless nobody has asked
  bool define_metric_ = false;
  std::unique_ptr<Unfolder> unfolder_;
};

template <class Triangulation>
Vertex_places<Triangulation>::Vertex_places(const Vertex_places& other)
    : own_(other.own_ ? std::make_unique<Integer_coordinates>(*other.own_) : nullptr),
      state_(other.state_), define_metric_(other.define_metric_) {}

template <class Triangulation>
Vertex_places<Triangulation>::Vertex_places(Vertex_places&&) noexcept = default;

template <class Triangulation>
auto Vertex_places<Triangulation>::operator=(Vertex_places&&) noexcept -> Vertex_places& = default;

template <class Triangulation>
Vertex_places<Triangulation>::~Vertex_places() = default;

template <class Triangulation>
void Vertex_places<Triangulation>::attach(const Triangulation& t, Exact_euclidean_metric& metric) {
  unfolder_ = std::make_unique<Unfolder>(t, *this);
  metric.unfold_by(*unfolder_);
}

template <class Triangulation>
void Vertex_places<Triangulation>::start(const Triangulation& t) const {
  state_ = State::shared;
  if (is_shared(t)) return;
  Replayed_flips flips(connectivity_of(t), t.metric());
  own_ = std::make_unique<Integer_coordinates>();
  own_->start(Started{surface_of(t, flips.mesh())});
  state_ = flips.replay(*own_) ? State::own : State::impossible;
  if (state_ == State::impossible) own_.reset();
}

template <class Triangulation>
std::shared_ptr<const Input> Vertex_places<Triangulation>::surface_of(const Triangulation& t,
                                                                      const Gluing_map& mesh) {
  if (t.input().has_surface() && t.input().is_defined_by_metric()) return t.shared_input();
  return std::make_shared<Input>(mesh, t.input().metric(), t.input().names());
}

// Other metrics are defined by moves.
template <class Triangulation>
struct No_vertex_places {
  static const Integer_coordinates* on_input(const Triangulation& t) {
    if constexpr (std::derived_from<typename Triangulation::Correspondence, Integer_coordinates>)
      return &t.correspondence();
    else
      return nullptr;
  }
  template <class Metric>
  bool define(const Triangulation&, Metric&) {
    return true;
  }
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
