// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_SIMPLIFICATION_ISOMETRY_DEVELOPED_FACES_H
#define CGAL_INTRINSIC_SIMPLIFICATION_ISOMETRY_DEVELOPED_FACES_H

#include <CGAL/Intrinsic_simplification/isometry/Square_root_field.h>
#include <CGAL/Intrinsic_simplification/isometry/Value_recipes.h>
#include <CGAL/Intrinsic_triangulations/connectivity/Gluing_map.h>
#include <CGAL/Intrinsic_triangulations/formulas/Diamond.h>

#include <cstdint>
#include <unordered_map>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

/*
Names the sides of faces as vectors of the plane, complex numbers, where moves change faces. Each
face of a triangulation has a frame, in which its first side is 1; turns take vectors from one frame
to the next. A face that a move makes has the frame of one of the faces before.

So squared lengths and areas follow from products and sums. Formulas of a flip divide by a squared
length, which takes exponentially long in a field of many roots. On a prism, an edge about it has a
root from each side that it crosses, but a turn has two.
*/
class Developed_faces {
public:
  using Halfedge = Gluing_map::Halfedge;
  using Value = Value_recipes::Id; // of a squared length or a quadruple area

  // \param recipes of values of a triangulation, with its mesh
  explicit Developed_faces(const Value_recipes& recipes);

  // Gives the face across a halfedge the frame of its own one. \param mesh before the move
  void bring_across(const Gluing_map& mesh, Halfedge h);
  // After that: sets a side that closes a triangle with two others, in their direction, and names
  // its squared length and the area.
  void close(Halfedge h, Halfedge first, Halfedge second, Value squared, Value area);
  // Names the area of the triangle with two sides.
  void set_area(Value area, Halfedge first, Halfedge second);
  // Sets that both faces at the edge have one frame, as after a flip.
  void join(Halfedge h);

  // Computes values in the field, each once.
  class Evaluation;

private:
  using Id = std::uint32_t; // of a complex number
  enum class Kind : std::uint8_t { product, inverse, closing };
  struct Node {
    Kind kind;
    Id a, b;                // of an inverse, a alone
    std::uint32_t from, to; // the frames between which it turns, by their faces
  };
  // the scalar or the cross product of two vectors, in a frame
  struct Quantity {
    Id a, b;
    std::uint32_t frame;
    bool is_area;
  };

  Id product(Id a, Id b) {
    return a == one() ? b : b == one() ? a : add({Kind::product, a, b, 0, 0});
  }
  Id add(const Node& n) {
    nodes_.push_back(n);
    return first_node() + static_cast<Id>(nodes_.size()) - 1;
  }
  // Numbers of the start come first: of each halfedge, as a vector and as a turn.
  Id one() const { return 2 * static_cast<Id>(face_.size()); }
  Id first_node() const { return one() + 1; }
  Value unit(std::uint32_t face) const { return recipes_.length_of_edge(first_side_[face] / 2); }

  const Value_recipes& recipes_;
  std::vector<std::uint32_t> face_, next_; // of each halfedge at the start
  std::vector<std::uint32_t> first_side_;  // of each face at the start
  std::vector<Id> vector_, turn_;          // of each halfedge: itself, and from across to here
  std::vector<std::uint32_t> frame_;       // of each halfedge
  std::vector<Node> nodes_;
  std::unordered_map<Value, Quantity> quantities_;
};

class Developed_faces::Evaluation {
public:
  using Number = Square_root_field::Number;

  Evaluation(const Developed_faces& faces, Square_root_field* field)
      : faces_(&faces), values_(faces.recipes_, field) {}

  // \throws Undecidable if edges cross too many triangles
  // \throws std::length_error if numbers of the field are too long
  const Number& operator()(Value id);
  Diamond_values<Number> operator()(const Value_recipes::Diamond_ids& d);

private:
  using Complex = std::pair<Number, Number>;

  const Complex& complex(Id id);
  void compute_next();
  Complex vector_at_start(std::uint32_t halfedge);
  Complex turn_at_start(std::uint32_t halfedge);
  Complex computed(const Node& n);

  const Developed_faces* faces_;
  Value_recipes::Evaluation<Number> values_; // of the start
  std::unordered_map<Value, Number> moved_values_;
  std::unordered_map<Id, Complex> complex_;
  std::vector<Id> stack_;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_SIMPLIFICATION_ISOMETRY_DEVELOPED_FACES_H
