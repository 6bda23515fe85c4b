// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_DECIDING_EXACT_MEMORY_H
#define CGAL_INTRINSIC_TRIANGULATIONS_DECIDING_EXACT_MEMORY_H

#include <CGAL/Intrinsic_triangulations/connectivity/Gluing.h>
#include <CGAL/Intrinsic_triangulations/correspondence/curves/Insertion_placer.h>
#include <CGAL/Intrinsic_triangulations/correspondence/curves/Unfolded_face.h>
#include <CGAL/Intrinsic_triangulations/correspondence/curves/normal_coordinates.h>
#include <CGAL/Intrinsic_triangulations/correspondence/curves/points_on_input.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/Diamond_unfolder.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/Integer_coordinates.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/No_correspondence.h>
#include <CGAL/Intrinsic_triangulations/deciding/Followed_values.h>
#include <CGAL/Intrinsic_triangulations/exact/Exact_ladder.h>
#include <CGAL/Intrinsic_triangulations/exact/Input_face_intervals.h>
#include <CGAL/Intrinsic_triangulations/exact/numbers/Ball.h>
#include <CGAL/Intrinsic_triangulations/exact/numbers/Double_double.h>
#include <CGAL/Intrinsic_triangulations/exact/proofs/flat.h>
#include <CGAL/Intrinsic_triangulations/exact/unfolding/Flip_list.h>
#include <CGAL/Intrinsic_triangulations/exact/unfolding/Replayed_faces.h>
#include <CGAL/Intrinsic_triangulations/exact/unfolding/figures.h>
#include <CGAL/Intrinsic_triangulations/formulas/Diamond.h>
#include <CGAL/Intrinsic_triangulations/formulas/Face_values.h>
#include <CGAL/Intrinsic_triangulations/formulas/Vertex_star.h>
#include <CGAL/Intrinsic_triangulations/input/Input.h>
#include <CGAL/Intrinsic_triangulations/triangulation/Moves.h>

#include <CGAL/Interval_nt.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// how often an edge, or the sides of a face, are crossed
inline std::size_t number_of_crossings(const Integer_coordinates& c, std::uint32_t edge) {
  return static_cast<std::size_t>(crossings(c.normal_coordinate(edge)));
}
inline std::size_t number_of_crossings(const Integer_coordinates& c, const Indexed_face& f) {
  return number_of_crossings(c, f.edges[0]) + number_of_crossings(c, f.edges[1]) +
         number_of_crossings(c, f.edges[2]);
}

// How many triangles are unfolded rather than repeating one flip, in up to 106 bits and in more: a
// flip took 0.2 microseconds in 106 bits and 2.4 in 256, a triangle 0.08 in doubles and then in 106
// bits, which are enough for it.
inline constexpr std::size_t triangles_per_short_flip = 4, triangles_per_long_flip = 32;

// Whether the input triangles under edges, or faces, are not many more than the flips, which can be
// repeated instead. Up to 32 are always unfolded: with 8 or 128 times on the data set are the same.
template <class Elements>
bool are_worth_unfolding(const Integer_coordinates& c, const Elements& elements,
                         const Flip_list& flips,
                         std::size_t triangles_per_flip = triangles_per_short_flip) {
  const std::size_t most = 32 + triangles_per_flip * flips.size();
  std::size_t all = 0;
  for (auto i = elements.begin(); i != elements.end() && all <= most; ++i)
    all += number_of_crossings(c, *i);
  return all <= most;
}

// Stores which intrinsic faces lie in a flat part of the input: faces in space that are connected
// across edges over which they are exactly coplanar. Two intrinsic faces of one part form a diamond
// in its plane, before and after a flip. Nearly all flips on CAD surfaces are of this kind.
class Flat_parts {
public:
  // of no part
  static constexpr std::uint32_t none = Gluing::none;

  explicit Flat_parts(const Input& input) : part_of_input_(input.number_of_faces(), unknown) {}

  // The part in which a diamond of two faces lies, named by a face of the input in it. `unfold()`
  // returns the input under the diamond, which is wholly flat or not flat.
  template <class Unfold>
  std::uint32_t part(const Input& input, std::uint32_t f, std::uint32_t g, const Unfold& unfold) {
    if (std::max(f, g) >= part_.size()) part_.resize(std::max(f, g) + 1, unknown);
    if (part_[f] == unknown || part_[g] == unknown) {
      const std::uint32_t both = part_of(input, unfold().triangles);
      for (const std::uint32_t x : {f, g})
        if (both != none || part_[x] == unknown) part_[x] = both;
      ++number_of_searches_;
    }
    return part_[f] == part_[g] ? part_[f] : none;
  }
  // the part in which all triangles are
  std::uint32_t part_of(const Input& input, const Unfolded_diamond::Triangles& triangles);
  // number of diamonds unfolded for this
  std::size_t number_of_searches() const { return number_of_searches_; }

  // follows a flip; two faces that are not flat rarely become flat
  void flip(std::uint32_t f, std::uint32_t g) {
    if (known(f) == known(g)) return;
    change(f);
    change(g);
  }
  // follows any other change of a face
  void change(std::uint32_t face) {
    if (face < part_.size()) part_[face] = unknown;
  }

private:
  static constexpr std::uint32_t unknown = none - 1;

  std::uint32_t known(std::uint32_t face) const {
    return face < part_.size() ? part_[face] : unknown;
  }

  void find_part(const Input& input, std::uint32_t name);

  std::vector<std::uint32_t> part_of_input_; // of each face of the input
  std::vector<std::uint32_t> part_;          // of each intrinsic face
  std::size_t number_of_searches_ = 0;
};

// Encloses values of faces that cross long turns about input vertices, see `Turned_positions`. A
// copy starts anew.
class Turned_faces {
public:
  using FT = Interval_nt<false>;

  Turned_faces();
  Turned_faces(const Turned_faces&);
  Turned_faces(Turned_faces&&);
  Turned_faces& operator=(const Turned_faces&);
  Turned_faces& operator=(Turned_faces&&) noexcept;
  ~Turned_faces();

  // The values of the face of a halfedge, from that on. \param bits 53 or 106
  template <class View>
  Face_values<FT> values(const View& view, const Integer_coordinates& c, std::uint32_t h,
                         unsigned bits) {
    face_.unfold(view, c, h, values_of(c.input()));
    return bits <= 53 ? face_.face_values() : short_values(c.input());
  }

  // how many steps along curves were taken since the last call of this function
  std::size_t take_steps() {
    const std::size_t before = std::exchange(steps_, face_.development().steps());
    return steps_ - before;
  }

private:
  // of faces of the input
  Unfolded_face<FT>::Values values_of(const Input& input);
  // of the unfolded face, in 106 bits
  Face_values<FT> short_values(const Input& input);

  Unfolded_face<FT> face_;
  Unfolded_face<Short_ball> short_face_;
  Input_face_intervals<FT> input_;
  Input_face_intervals<Short_ball> short_input_;
  std::size_t steps_ = 0;
};

// The memory of a decider, flat parts included; a copy starts anew where possible.
struct Exact_memory : No_correspondence {
  Exact_ladder ladder;
  Diamond_unfolder unfolder;
  Turned_faces turned_faces;
  Input_face_intervals<Interval_nt<false>> input_faces;
  std::optional<Flat_parts> flat_parts;
  std::size_t steps = 0;        // steps for single elements since the last move or pass
  std::size_t enough_steps = 0; // the least cost of a pass over all, without a list of flips
  unsigned passes = 0;          // over all elements
  bool are_sharp = false;       // all faces, since the last move
  bool are_found = false;       // values of all edges and faces that need it, since the last move
  Followed_values values;

  Exact_memory();
  Exact_memory(const Exact_memory&);
  Exact_memory(Exact_memory&&);
  Exact_memory& operator=(const Exact_memory&);
  Exact_memory& operator=(Exact_memory&&) noexcept;
  ~Exact_memory();

  // follows moves: forgets what queries stored, so that they cannot change later results
  template <class Triangulation>
  void make_room(const Triangulation& t, const Flip&) {
    if constexpr (requires { t.decider().follow_flips(); })
      if (values.is_time_to_follow(num_edges(t.mesh()))) t.decider().follow_flips();
  }
  template <class Triangulation>
  void make_room(const Triangulation& t, const Insertion_in_face&) {
    if constexpr (requires { t.decider().follow_flips(); }) t.decider().follow_insertion();
  }
  template <class Triangulation>
  void make_room(const Triangulation& t, const Insertion_on_border&) {
    if constexpr (requires { t.decider().follow_flips(); }) t.decider().follow_insertion();
  }
  template <class Triangulation, class Move>
  void make_room(const Triangulation&, const Move&) {}
  template <class Triangulation>
  void after(const Triangulation& t, const Flip& move) noexcept {
    forget();
    if constexpr (requires { t.decider().follow_flips(); }) values.flip(t.metric(), move);
    if (flat_parts) flat_parts->flip(move.diamond.f, move.diamond.g);
  }
  template <class Triangulation>
  void after(const Triangulation&, const Insertion_in_face& move) noexcept {
    forget();
    values.insert(move.edges_and_faces());
    forget_flat(move.faces);
  }
  template <class Triangulation>
  void after(const Triangulation&, const Removal_from_face& move) noexcept {
    forget();
    values.remove(move.edges_and_faces());
    forget_flat(move.faces);
  }
  template <class Triangulation>
  void after(const Triangulation&, const Insertion_on_border& move) noexcept {
    forget();
    values.insert(move.edges_and_faces());
    forget_flat(std::array{move.f, move.g});
  }
  template <class Triangulation>
  void after(const Triangulation&, const Removal_from_border& move) noexcept {
    forget();
    values.remove(move.edges_and_faces());
    forget_flat(std::array{move.f, move.g});
  }
  template <class Faces>
  void forget_flat(const Faces& faces) noexcept {
    if (flat_parts)
      for (const std::uint32_t f : faces) flat_parts->change(f);
  }
  void forget() {
    are_sharp = are_found = false;
    steps = enough_steps = 0;
  }
};

// Other metrics need no memory.
struct No_exact_memory : No_correspondence {};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_DECIDING_EXACT_MEMORY_H
