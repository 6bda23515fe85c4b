// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_SIMPLIFICATION_ISOMETRY_LENGTHS_DEVELOPED_FACES_H
#define CGAL_INTRINSIC_SIMPLIFICATION_ISOMETRY_LENGTHS_DEVELOPED_FACES_H

#include <CGAL/Intrinsic_simplification/isometry/Square_root_field.h>
#include <CGAL/Intrinsic_simplification/isometry/lengths/Chart_grid.h>
#include <CGAL/Intrinsic_simplification/isometry/lengths/Frame_maps.h>
#include <CGAL/Intrinsic_simplification/isometry/lengths/Length_chain.h>
#include <CGAL/Intrinsic_simplification/isometry/lengths/Plane_charts.h>
#include <CGAL/Intrinsic_simplification/isometry/lengths/Value_recipes.h>
#include <CGAL/Intrinsic_simplification/isometry/lengths/Value_table.h>
#include <CGAL/Intrinsic_triangulations/connectivity/Gluing_map.h>
#include <CGAL/Intrinsic_triangulations/formulas/Diamond.h>
#include <CGAL/Intrinsic_triangulations/formulas/Plane_vector.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <unordered_map>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

/*
Names the corners of faces as points of planes, where moves change faces. Each face of a
triangulation has a frame: that of its chart, or its own, in which its first side is 1. Maps take
points from one frame to the next. A face that a move makes has the frame of one of the faces
before, and corners of theirs: moves make no new numbers but where they bring a face to another
frame.

Squared lengths and areas follow from corners by products and sums. Formulas of a flip divide by a
squared length, which takes exponentially long in a field of many roots, and their errors grow from
flip to flip. On a prism, an edge about it has a root from each side that it crosses, but a map has
two.
*/
class Developed_faces {
public:
  using Halfedge = Gluing_map::Halfedge;
  using Value = Value_recipes::Id; // of a squared length or a quadruple area: first those of the
                                   // triangulation at the start
  using Point = std::uint32_t;     // first the source of each halfedge at the start

  // \param recipes of values of a triangulation, with its mesh
  explicit Developed_faces(const Value_recipes& recipes);
  Developed_faces(const Developed_faces&) = delete;
  Developed_faces& operator=(const Developed_faces&) = delete;

  // the first side of each face at the start
  const std::vector<std::uint32_t>& first_sides() const { return first_side_; }
  // Gives all faces of a chart one frame. \pre no move was made \param is_flat of each vertex
  void set_charts(Plane_charts charts, const std::vector<char>& is_flat);

  // Gives the face across a halfedge the frame of its own one. \param mesh before the move
  void bring_across(const Gluing_map& mesh, Halfedge h);
  // After that: turns the edge. \param mesh before the flip
  void flip(const Gluing_map& mesh, Halfedge h);
  // Gives a face the frame in which its corners are nearest to those at the start: otherwise frames
  // stray, and coordinates have roots from far away.
  void choose_frame(const Gluing_map& mesh, Halfedge h);

  Point source(Halfedge h) const { return point_[h.index]; }
  // whether the faces at an edge lie in one plane of coordinates
  bool is_in_one_frame(Halfedge h) const { return map_[h.index] == Frame_maps::identity; }
  // The frame of the face of a halfedge, whose unit is the square root of a length with a name.
  std::uint32_t frame(Halfedge h) const { return frame_[h.index]; }
  Value unit(std::uint32_t frame) const { return recipes_.length_of_edge(first_side_[frame] / 2); }
  // The grid of a frame, or null.
  const Chart_grid* grid(std::uint32_t frame) const { return charts_.grid(frame); }
  // The place of a point on the grid of its frame; nothing if it is elsewhere. \pre there is a grid
  std::optional<Grid_point> grid_point(Point p) const;
  // Names the squared length of a side of a face, and the area of a face, from now on.
  Value name_length(const Gluing_map& mesh, Halfedge h);
  Value name_area(const Gluing_map& mesh, Halfedge h);

  // The squared length that has a name, by the triangles and charts that its edge crosses; nothing
  // if one has irrational lengths.
  std::optional<Length_chain> chain(Value length) const;

  // Computes values and points in one number type, each once.
  template <class FT>
  class Evaluation;

private:
  // the squared distance of two points, or the quadruple area of three
  struct Quantity {
    std::array<Point, 3> points;
    std::uint32_t frame;
    bool is_area;
  };
  struct Image {
    Frame_maps::Map map;
    Point start;
    std::optional<Grid_point> grid_point = std::nullopt;
  };

  std::uint32_t number_of_halfedges() const { return static_cast<std::uint32_t>(face_.size()); }
  void start();
  // Maps the face of a halfedge to another frame.
  void apply(const Gluing_map& mesh, Halfedge h, Frame_maps::Map map, std::uint32_t frame);
  void join_creases(const std::vector<char>& is_flat);
  Frame_maps::Map map_of(Point p) const {
    return p < number_of_halfedges() ? Frame_maps::identity
                                     : images_[p - number_of_halfedges()].map;
  }
  Point start_of(Point p) const {
    return p < number_of_halfedges() ? p : images_[p - number_of_halfedges()].start;
  }
  Point image(Frame_maps::Map map, Point p);
  std::optional<Image> across_first_edge(const Image& i);
  std::optional<Grid_point> grid_point(const Image& i) const;
  Value add(const Quantity& q);
  // A frame with rational lengths: `square` is that of the quadruple area of its first face.
  struct Rational_frame {
    Gmpq square;
    std::array<Plane_number, 3> corners; // without a chart, of its face
  };
  std::optional<Gmpq> rational_length(std::uint32_t edge) const;
  std::optional<Rational_frame> rational_frame(std::uint32_t frame) const;
  Plane_number place(const Rational_frame& frame, std::uint32_t halfedge) const;
  bool append_letter(Frame_maps::Map letter, std::vector<Length_chain::Link>& links) const;

  const Value_recipes& recipes_;
  std::vector<std::uint32_t> face_, next_; // of each halfedge at the start
  std::vector<std::uint32_t> first_side_;  // of each face at the start
  Plane_charts charts_;
  std::vector<std::uint32_t> frame_at_start_; // of each face
  Frame_maps maps_;
  std::vector<Point> point_, point_at_start_; // where each halfedge starts
  std::vector<Frame_maps::Map> map_,          // of each halfedge: from the frame across to its own
      map_at_start_;
  std::vector<std::uint32_t> frame_; // of each halfedge
  std::vector<Image> images_;
  std::unordered_map<std::uint64_t, Point> known_images_;
  std::vector<Quantity> quantities_;
};

/*
Number types are `Ball`s, with rounding to the nearest, and numbers of a `Square_root_field`.
*/
template <class FT>
class Developed_faces::Evaluation {
public:
  using Vector = Plane_vector<FT>;

  // \param field that of square roots, for its numbers
  explicit Evaluation(const Developed_faces& faces, Square_root_field* field = nullptr)
      : faces_(&faces), values_(faces.recipes_, field) {}

  // \throws Undecidable if edges cross too many triangles
  // \throws std::length_error if numbers of the field are too long
  const FT& operator()(Value id);
  Diamond_values<FT> operator()(const Value_recipes::Diamond_ids& d) {
    const auto at = [&](std::size_t k) { return (*this)(d[k]); };
    return {at(0), at(1), at(2), at(3), at(4), at(5), at(6)};
  }
  const Vector& point(Point p);

private:
  using Map = Frame_maps::Map;
  struct Motion {
    Vector turn, shift;
  };

  FT computed(const Quantity& q);
  Vector computed(const Image& image);
  Vector point_at_start(std::uint32_t halfedge);
  const Motion& motion(Map map);
  Motion computed(Map map);
  Motion motion_at_start(std::uint32_t halfedge);
  Vector in_chart(const Plane_number& z, std::uint32_t chart);

  const Developed_faces* faces_;
  Value_recipes::Evaluation<FT> values_; // of the start
  Value_table<FT> moved_values_;         // by what was named
  Value_table<FT, Vector> points_;
  std::unordered_map<Map, Motion> motions_;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_SIMPLIFICATION_ISOMETRY_LENGTHS_DEVELOPED_FACES_H
