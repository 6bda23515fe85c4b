// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_SIMPLIFICATION_SIMPLIFICATION_COARSE_MESH_H
#define CGAL_INTRINSIC_SIMPLIFICATION_SIMPLIFICATION_COARSE_MESH_H

#include <CGAL/Intrinsic_simplification/simplification/Fine_surface.h>
#include <CGAL/Intrinsic_simplification/simplification/Quadratic_form.h>
#include <CGAL/Intrinsic_triangulations/connectivity/Gluing.h>
#include <CGAL/Intrinsic_triangulations/support/cmath.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// A triangle of the surface that becomes coarse. Side k runs from `origin[k]` to the next corner.
struct alignas(64) Coarse_face {
  std::array<std::uint32_t, 3> glue;   // the side that each side is glued to, or none
  std::array<std::uint32_t, 3> origin; // vertices
  Side_values length;                  // squared
  float spread = 0;                    // the logarithm of the ratio of the bounds of its stretch
  std::uint32_t first_point = Gluing::none; // of the points in it, a list
  std::uint32_t recorded_in = 0;            // the last step that has recorded it
  std::uint8_t kept_sides = 0;              // a bit for each side that must stay an edge
  bool is_removed = false;
  bool is_listed = false; // while changed faces are listed
};

// Forms of a face that are proven to bound that of the fine surface.
struct Face_forms {
  Side_values above, below;
};

// A vertex of the fine surface that is gone: a point in a face.
struct Point_on_coarse {
  std::uint32_t face = Gluing::none;
  std::uint32_t next = Gluing::none; // the next point in the face
  std::array<double, 3> weights{};
};

// The outgoing side of a vertex is another one now.
struct Turned_side {
  std::uint32_t vertex;
  double angle; // from the old one counterclockwise, on the surface
};

// Where the vertices and the faces of a surface are stored: neighbours near each other, since steps
// read and write small regions anywhere.
struct Near_order {
  explicit Near_order(const Gluing& g);
  std::vector<std::uint32_t> vertex, face; // places, by numbers on the surface
};

// The triangulation while vertices are removed. Changes are recorded, and can be taken back.
class Coarse_mesh {
public:
  explicit Coarse_mesh(const Fine_surface& fine);

  static std::uint32_t next(std::uint32_t h) { return Gluing::next(h); }
  static std::uint32_t previous(std::uint32_t h) { return h % 3 == 0 ? h + 2 : h - 1; }

  // The vertices and faces here, in the order of the fine surface.
  const std::vector<std::uint32_t>& vertices() const { return order_.vertex; }
  const std::vector<std::uint32_t>& faces() const { return order_.face; }
  // The number of a vertex on the fine surface.
  std::uint32_t number(std::uint32_t v) const { return number_[v]; }
  // The side here of a side of the fine surface.
  std::uint32_t side(std::uint32_t h) const {
    return h == Gluing::none ? h : 3 * order_.face[h / 3] + h % 3;
  }
  const Coarse_face& face(std::uint32_t f) const { return faces_[f]; }
  const Face_forms& forms(std::uint32_t f) const { return forms_[f]; }
  const Point_on_coarse& point(std::uint32_t v) const { return points_[v]; }
  std::uint32_t glued(std::uint32_t h) const { return faces_[h / 3].glue[h % 3]; }
  std::uint32_t origin(std::uint32_t h) const { return faces_[h / 3].origin[h % 3]; }
  double length(std::uint32_t h) const { return faces_[h / 3].length[h % 3]; } // squared
  // A side from the vertex; on the border the one with the border on its right.
  std::uint32_t outgoing(std::uint32_t v) const { return outgoing_[v]; }
  bool is_kept_side(std::uint32_t h) const {
    return (faces_[h / 3].kept_sides >> (h % 3) & 1) != 0;
  }
  // Whether flips may replace the edge: it is between two faces, and need not stay.
  bool is_flippable(std::uint32_t h) const {
    const std::uint32_t g = glued(h);
    return g != Gluing::none && g / 3 != h / 3 && !is_kept_side(h);
  }
  // Four times the area.
  double quadruple_area(std::uint32_t f) const;
  // The angle of a face at the vertex where a side of it starts.
  double corner_angle(std::uint32_t h) const;

  // Begins a step: what came before cannot be taken back.
  void begin();
  // Takes back all changes of the step.
  void take_back();
  // The faces of which the step has changed corners or lengths, some of them several times.
  const std::vector<std::uint32_t>& changed() const { return changed_; }
  // The same, each of them once.
  void list_changed(std::vector<std::uint32_t>& faces);

  // Records from now on by what angles outgoing sides turn, for directions that are given by them.
  void track_turns() { tracks_turns_ = true; }
  bool tracks_turns() const { return tracks_turns_; }
  void add_turn(std::uint32_t v, double angle) { turned_sides_.push_back({v, angle}); }
  // What has turned in the step, one turn after another.
  const std::vector<Turned_side>& turned_sides() const { return turned_sides_; }

  // What may be changed, after it is recorded.
  Coarse_face& change(std::uint32_t f) {
    changed_.push_back(f);
    return change_neighbour(f);
  }
  // The same for a face that is only glued to others.
  Coarse_face& change_neighbour(std::uint32_t f) {
    Coarse_face& face = faces_[f];
    if (face.recorded_in != step_) {
      changed_faces_.emplace_back(f, face);
      face.recorded_in = step_;
    }
    return face;
  }
  Face_forms& change_forms(std::uint32_t f) {
    changed_forms_.emplace_back(f, forms_[f]);
    return forms_[f];
  }
  void set_outgoing(std::uint32_t v, std::uint32_t h) {
    changed_outgoing_.emplace_back(v, outgoing_[v]);
    outgoing_[v] = h;
  }
  // Takes all points out of a face that was recorded, and appends them to `points`.
  void take_points(std::uint32_t f, std::vector<std::uint32_t>& points);
  void put_point(std::uint32_t v, std::uint32_t f, const std::array<double, 3>& weights);
  // Glues two recorded sides.
  void glue(std::uint32_t h, std::uint32_t g) {
    faces_[h / 3].glue[h % 3] = g;
    if (g != Gluing::none) faces_[g / 3].glue[g % 3] = h;
  }
  void keep_side(std::uint32_t h) {
    faces_[h / 3].kept_sides = static_cast<std::uint8_t>(faces_[h / 3].kept_sides | 1U << h % 3);
  }
  void set_length(std::uint32_t h, double l) { faces_[h / 3].length[h % 3] = l; }
  // Needs no record: it follows from what is recorded.
  void set_spread(std::uint32_t f, double spread) { faces_[f].spread = static_cast<float>(spread); }

  // Flips an edge as Euclid does: forms and points move. Returns whether the faces at it are
  // certainly convex together; otherwise nothing changes.
  bool flip(std::uint32_t h);
  // Whether the angles opposite the edge sum to more than pi, by more than rounding.
  bool violates_delaunay(std::uint32_t h) const;

private:
  void rewire(std::uint32_t h, double length);
  void start_forms(const Fine_surface& fine);

  Near_order order_;
  std::vector<std::uint32_t> number_; // of each vertex
  std::vector<Coarse_face> faces_;
  std::vector<Face_forms> forms_;
  std::vector<std::uint32_t> outgoing_;
  std::vector<Point_on_coarse> points_;
  std::vector<std::uint32_t> changed_;
  std::vector<std::pair<std::uint32_t, Coarse_face>> changed_faces_;
  std::vector<std::pair<std::uint32_t, Face_forms>> changed_forms_;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> changed_outgoing_;
  std::vector<std::pair<std::uint32_t, Point_on_coarse>> changed_points_;
  std::vector<std::uint32_t> moving_;
  std::vector<Turned_side> turned_sides_;
  std::uint32_t step_ = 0;
  bool tracks_turns_ = false;
};

// Four times the area of a triangle, by squared lengths; zero if there is none. Which side is the
// longest cannot be predicted: nothing branches on it.
inline double quadruple_area_of(double a, double b, double c) {
  const double low = std::min(a, b), high = std::max(a, b);
  const double longest = std::max(high, c), middle = std::min(high, c);
  const double p = low + middle - longest, s = 4 * low * middle - p * p;
  return std::sqrt(std::max(0., s));
}

// Whether three squared lengths are those of a triangle with an area: proven.
bool is_proven_triangle(const Side_values& l);

// Whether three points turn to the left: proven.
bool is_proven_left_turn(const Exact_point& p, const Exact_point& q, const Exact_point& r);

// The logarithm of the ratio of the stretch bounds of a face, in doubles.
double spread_of(const Side_values& length, const Face_forms& forms);

// The point with weights in a face of which side h is the first side in the plane.
Exact_point place_in(const Plane_triangle& p, const std::array<double, 3>& weights,
                     std::uint32_t h);

// The weights of a point in a triangle; negative ones outside.
std::array<double, 3> weights_in(const Plane_triangle& p, const Exact_point& q);

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_SIMPLIFICATION_SIMPLIFICATION_COARSE_MESH_H
