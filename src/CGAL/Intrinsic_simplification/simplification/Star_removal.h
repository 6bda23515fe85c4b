// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_SIMPLIFICATION_SIMPLIFICATION_STAR_REMOVAL_H
#define CGAL_INTRINSIC_SIMPLIFICATION_SIMPLIFICATION_STAR_REMOVAL_H

#include <CGAL/Intrinsic_simplification/simplification/Coarse_mesh.h>
#include <CGAL/Intrinsic_simplification/simplification/Least_value.h>
#include <CGAL/Intrinsic_simplification/simplification/Quadratic_form.h>
#include <CGAL/Intrinsic_simplification/simplification/Vertex_star.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

inline constexpr Exact_point middle_of_star{0, 0};

inline double cross(const Exact_point& p, const Exact_point& q) { return p.x * q.y - p.y * q.x; }
inline double squared_norm(const Exact_point& p) { return p.x * p.x + p.y * p.y; }
inline Exact_point minus(const Exact_point& p, const Exact_point& q) {
  return {p.x - q.x, p.y - q.y};
}

// Removes a flat vertex: its star is laid out in the plane, with the vertex at the origin, and
// becomes other triangles between the points of its rim. Objects are reused for their memory.
class Star_removal {
public:
  // Returns whether all is proven: triangles in the plane are counterclockwise, new lengths are
  // those of triangles, and new forms bound the old ones. If not, some changes may have been made.
  bool remove(Coarse_mesh& mesh, const Vertex_star& star, std::uint32_t v);

  // After a removal: one side of each edge of the new triangles.
  void list_edges(std::vector<std::uint32_t>& sides) const;

private:
  struct Rim_side {         // of the polygon that is left
    std::uint32_t rim;      // the number of the rim edge; none: a side of a new triangle
    std::uint32_t triangle; // the number of that, or of the one behind a side of a triangle
    std::uint32_t glued;    // a side outside, or of a new triangle; none: the border
    double length;
    bool is_kept;
  };
  struct New_triangle {
    std::array<std::uint32_t, 3> corners; // points
    std::array<Rim_side, 3> sides;
  };
  struct Located {
    std::uint32_t triangle;
    std::array<double, 3> weights;
    double least; // weight
  };

  bool lay_out(const Vertex_star& star);
  bool cut_ears(const Vertex_star& star);
  void cut_ear(std::uint32_t tip, std::uint32_t face);
  bool has_proven_lengths() const;
  bool find_forms(const Coarse_mesh& mesh, const Vertex_star& star);
  void take_faces(Coarse_mesh& mesh, const Vertex_star& star, std::uint32_t v);
  void replace_rim_in_outside(const Coarse_mesh& mesh, const Vertex_star& star);
  Located locate(const Exact_point& place, std::uint32_t from) const;
  void put_triangles(Coarse_mesh& mesh, std::uint32_t v);
  void move_points(Coarse_mesh& mesh);
  void find_directions(const Coarse_mesh& mesh, const Vertex_star& star);
  void add_turns(Coarse_mesh& mesh) const;
  void start_polygon(const Coarse_mesh& mesh, const Vertex_star& star);
  double ear_rank(std::uint32_t tip) const;
  bool is_ear(std::uint32_t b) const;
  void glue_sides(Coarse_mesh& mesh);
  Plane_triangle old_triangle(std::size_t k) const;
  Plane_triangle new_triangle(const New_triangle& t) const;
  std::uint32_t far_side(const New_triangle& t) const;
  void find_overlapped(std::size_t number, const Vertex_star& star);
  void overlap(const Enclosed_form& above, const Enclosed_form& below);
  template <Form (*Join)(const Form&, const Form&)>
  static Form join_all(std::vector<const Enclosed_form*>& forms);

  std::vector<Exact_point> points_;           // of the rim
  std::vector<std::uint32_t> before_, after_; // neighbours of points that are left
  std::vector<Rim_side> polygon_sides_;       // from each of them
  Least_value ears_;                          // the rank of each tip; infinite: it is none
  std::vector<std::pair<std::uint32_t, double>> waiting_; // tips that may be ears later
  std::vector<New_triangle> triangles_;
  std::vector<std::uint32_t> new_faces_;
  std::vector<std::uint32_t> side_of_rim_, triangle_of_rim_; // new ones at each rim edge
  std::vector<std::uint32_t> outside_;                       // what was glued to each rim edge
  std::vector<std::uint32_t> corners_;                       // the vertices of the points
  std::vector<Proven_form> above_, below_;                   // of the new triangles
  std::vector<Enclosed_form> old_above_, old_below_;         // of the faces of the star
  std::vector<char> covers_; // of each new triangle: its forms bound those under its last side
  std::vector<const Enclosed_form*> overlapped_above_, overlapped_below_;
  std::vector<std::uint32_t> moving_;
  std::vector<Exact_point> places_;
  std::vector<std::uint32_t> near_;                          // of each place: a new triangle
  std::vector<std::pair<std::uint32_t, std::uint32_t>> rim_; // sides of it in order, and numbers
  std::vector<double> directions_; // of outgoing sides at the rim; not a number: not in the star
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_SIMPLIFICATION_SIMPLIFICATION_STAR_REMOVAL_H
