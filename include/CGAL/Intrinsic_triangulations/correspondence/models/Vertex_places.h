// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_MODELS_VERTEX_PLACES_H
#define CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_MODELS_VERTEX_PLACES_H

#include <CGAL/Intrinsic_triangulations/connectivity/Gluing_map.h>
#include <CGAL/Intrinsic_triangulations/connectivity/adaptors/Mesh_adaptor.h>
#include <CGAL/Intrinsic_triangulations/connectivity/as_gluing.h>
#include <CGAL/Intrinsic_triangulations/connectivity/graph_traits_Gluing_map.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/Integer_coordinates.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/No_correspondence.h>
#include <CGAL/Intrinsic_triangulations/exact/unfolding/Flip_list.h>
#include <CGAL/Intrinsic_triangulations/input/Input.h>
#include <CGAL/Intrinsic_triangulations/triangulation/Mover.h>
#include <CGAL/Intrinsic_triangulations/triangulation/Moves.h>

#include <CGAL/boost/graph/Euler_operations.h>

#include <concepts>
#include <cstddef>
#include <memory>
#include <optional>
#include <type_traits>
#include <utility>

namespace CGAL::Intrinsic_triangulations {

/*!
\brief requires a correspondence that integer coordinates restore.

Syntax of \ref ::RestorableCorrespondence, which describes its meaning.
*/
template <class Correspondence, class Triangulation>
concept RestorableCorrespondence = requires(Correspondence& c, const Triangulation& t,
                                            const Integer_coordinates& coordinates) {
  c.restore(t, coordinates);
};

/*!
\brief requires a correspondence that has integer coordinates.

Syntax of \ref ::IntegerCorrespondence, which describes its meaning.
*/
template <class Correspondence>
concept IntegerCorrespondence = requires(const Correspondence& c) {
  { c.integer_coordinates() } -> std::same_as<const Integer_coordinates&>;
};

namespace internal {

// The integer coordinates of a correspondence; null if it has none.
template <class Correspondence>
const Integer_coordinates* integer_coordinates_of(const Correspondence& c) {
  if constexpr (IntegerCorrespondence<Correspondence>)
    return &c.integer_coordinates();
  else
    return nullptr;
}

// Stores where the vertices and edges of a triangulation are on the input, for an exact metric: in
// the integer coordinates of the correspondence if there are any, else in its own. The first query
// makes its own from the list of flips; from then on they follow all moves. From the first
// insertion on they alone define the vertices, and there is no list.
template <class Triangulation>
class Vertex_places : public No_correspondence {
public:
  // takes the coordinates of a restored triangulation, which its correspondence has, too, if
  // possible
  void restore(const Triangulation& t, const Integer_coordinates& coordinates) {
    if (!is_shared(t)) own_ = coordinates;
    are_all_flips_ = were_all_flips_ = false;
  }

  // the flips since the input; null if there were other moves, or the triangulation was restored
  const Flip_list* flips() const { return are_all_flips_ ? &flips_ : nullptr; }

  // whether the next function takes constant time
  bool has_coordinates(const Triangulation& t) const { return own_ || is_shared(t); }
  // the coordinates; null if an edge crosses more input edges than they can count
  const Integer_coordinates* coordinates(const Triangulation& t) const {
    if (is_shared(t)) return integer_coordinates_of(t.correspondence());
    if (!own_ && can_count_) repeat_flips(t);
    return own_ ? &*own_ : nullptr;
  }

  // the same, if they are about the input of the triangulation and that has its surface
  const Integer_coordinates* on_input(const Triangulation& t) const {
    return is_defined_by_metric(t) ? coordinates(t) : nullptr;
  }

  // the values at the vertex whose insertion was announced last
  const auto& inserted_values(const Triangulation& t) const {
    return coordinates(t)->inserted_values();
  }

  // Observes moves like a correspondence. Adds to the record of an insertion what own coordinates
  // know, so that no other observer need find it.
  template <class Move>
  bool before(const Triangulation& t, Move& move) const {
    constexpr bool is_flip = std::is_same_v<std::remove_const_t<Move>, Flip>;
    if (!is_flip && coordinates(t) == nullptr) return false;
    if (!own_) return true;
    if (!own_->before(t, std::as_const(move))) {
      if (!is_flip || !are_all_flips_) return false;
      own_.reset(); // the flip must not be refused: from now on the list is enough
      can_count_ = false;
    }
    if constexpr (requires { move.place = own_->inserted_place(); })
      if (&own_->input() == &t.input()) {
        move.place = own_->inserted_place();
        if constexpr (Triangulation::has_correspondence && requires { move.seen; })
          move.seen = own_->inserted_direction();
      }
    return true;
  }
  template <class Move>
  void make_room(const Triangulation& t, const Move& move) {
    if constexpr (std::is_same_v<Move, Flip>) {
      if (are_all_flips_) flips_.make_room(move.ij);
    } else if (!are_all_flips_ && !were_all_flips_) {
      flips_.clear();
    }
    if (own_) own_->make_room(t, move);
  }
  template <class Move>
  void after(const Triangulation& t, const Move& move) noexcept {
    if constexpr (std::is_same_v<Move, Flip>) {
      if (!are_all_flips_)
        were_all_flips_ = false;
      else if (move.is_taken_back())
        flips_.forget_last();
      else
        flips_.add(move.ij);
    } else { // the removal that follows the first insertion takes it back
      constexpr bool is_removal = std::derived_from<Move, Removal_from_face> ||
                                  std::derived_from<Move, Removal_from_border>;
      were_all_flips_ = std::exchange(are_all_flips_, is_removal && were_all_flips_) && !is_removal;
    }
    if (own_) own_->after(t, move);
  }

  // before the first insertion
  static bool are_input_lengths_positive(const Triangulation& t) {
    return t.metric().are_input_lengths_positive();
  }
  // the connectivity by numbers; before the first insertion those of a gluing map have no gaps
  static Gluing_map connectivity(const Triangulation& t) {
    if constexpr (std::is_same_v<typename Triangulation::Mesh, Gluing_map>)
      return t.mesh();
    else
      return numbered_copy(t.mesh(), t.numbers());
  }

private:
  struct Started {
    std::shared_ptr<const Input> input;
    const std::shared_ptr<const Input>& shared_input() const { return input; }
  };

  // whether the input keeps its surface, and the metric defines it
  bool is_defined_by_metric(const Triangulation& t) const {
    const Input* const surface = t.input().surface();
    if (!is_defined_by_metric_)
      is_defined_by_metric_ = surface != nullptr && surface->is_defined_by_metric();
    return *is_defined_by_metric_; // linear: not to be found at every insertion
  }
  bool is_shared(const Triangulation& t) const {
    return integer_coordinates_of(t.correspondence()) != nullptr && is_defined_by_metric(t);
  }

  void repeat_flips(const Triangulation& t) const;

  Flip_list flips_;
  bool are_all_flips_ = true;   // that ever were
  bool were_all_flips_ = false; // before the last move, which was an insertion
  // mutable: a cache of the list, until they define the vertices
  mutable std::optional<Integer_coordinates> own_;
  mutable bool can_count_ = true;
  mutable std::optional<bool> is_defined_by_metric_; // the input; not set yet
};

template <class Triangulation>
void Vertex_places<Triangulation>::repeat_flips(const Triangulation& t) const {
  const Input* const surface = t.input().surface();
  Gluing_map mesh =
      surface != nullptr ? surface->mesh() : flips_.input_mesh(connectivity(t), t.input());
  Integer_coordinates coordinates;
  coordinates.start(
      Started{is_defined_by_metric(t)
                  ? std::shared_ptr<const Input>(t.shared_input(), t.input().surface())
                  : std::make_shared<const Input>(mesh, t.input().metric(), t.input().names())});
  const Mesh_adaptor<Gluing_map> numbers(mesh);
  for (std::size_t n = 0; n < flips_.size(); ++n) {
    const Flip move = flip_record(flips_[n], mesh, numbers);
    if (!coordinates.before(mesh, move)) {
      can_count_ = false;
      return;
    }
    CGAL::Euler::flip_edge(flips_[n], mesh);
    coordinates.after(mesh, move);
  }
  own_ = std::move(coordinates);
}

// Other metrics are defined by moves; one that stores nothing by the correspondence alone.
template <class Triangulation>
struct No_vertex_places : No_correspondence {
  static const Integer_coordinates* coordinates(const Triangulation& t) {
    return integer_coordinates_of(t.correspondence());
  }
  static const Integer_coordinates* on_input(const Triangulation& t) { return coordinates(t); }
  static const Flip_list* flips() { return nullptr; }
  // called with flips only
  static Gluing_map connectivity(const Triangulation&) { return {}; }
  static bool are_input_lengths_positive(const Triangulation&) { return true; }
};

} // namespace internal

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_MODELS_VERTEX_PLACES_H
