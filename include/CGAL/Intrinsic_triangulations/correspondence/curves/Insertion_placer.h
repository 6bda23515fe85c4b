// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_CURVES_INSERTION_PLACER_H
#define CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_CURVES_INSERTION_PLACER_H

#include <CGAL/Intrinsic_triangulations/correspondence/Intrinsic_view.h>
#include <CGAL/Intrinsic_triangulations/correspondence/curves/Unfolded_face.h>
#include <CGAL/Intrinsic_triangulations/correspondence/curves/normal_coordinates.h>
#include <CGAL/Intrinsic_triangulations/exact/Input_face_intervals.h>
#include <CGAL/Intrinsic_triangulations/exact/numbers/Ball.h>
#include <CGAL/Intrinsic_triangulations/exact/numbers/Double_double.h>
#include <CGAL/Intrinsic_triangulations/exact/numbers/Mpfr_number.h>
#include <CGAL/Intrinsic_triangulations/formulas/Face_values.h>
#include <CGAL/Intrinsic_triangulations/formulas/Vertex_star.h>
#include <CGAL/Intrinsic_triangulations/input/Input.h>
#include <CGAL/Intrinsic_triangulations/triangulation/Moves.h>
#include <CGAL/Intrinsic_triangulations/triangulation/Surface_point.h>
#include <CGAL/Intrinsic_triangulations/triangulation/concepts.h>

#include <CGAL/Interval_nt.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <type_traits>

namespace CGAL::Intrinsic_triangulations {

/// holds the place of a vertex before its insertion.
struct Placed_insertion {
  bool along_side = false; ///< on the first side of the face, which runs along an input edge
  Face_region region;      ///< the region of the face
  Surface_point location;  ///< the place on the input
};

namespace internal {

// from the values of a face to those from a halfedge of it on
template <class Faces>
auto values_from(const Input& input, Faces faces) {
  return [&input, faces](std::uint32_t x) {
    const Face_side s = input_side(input, x);
    const auto& [l, area] = faces(s.face);
    return Face_values<std::decay_t<decltype(area)>>{
        {l[s.slot], l[(s.slot + 1) % 3], l[(s.slot + 2) % 3]}, area};
  };
}

// a point of an edge, from the other side
inline Surface_point turned_around(const Surface_point& p) {
  return {p.halfedge ^ 1U, {p.weights[1], p.weights[0], 0}};
}

// the given place, if it is in the face, or one at weights
template <class Face, class View, class Coordinates>
std::optional<Place_in_face> place_in(const Face& face, const View& view,
                                      const Coordinates& coordinates, std::uint32_t h,
                                      const std::array<double, 3>& weights, bool along_side,
                                      const std::optional<Surface_point>& wanted = std::nullopt) {
  const Input& input = coordinates.input();
  if (!along_side) return wanted ? face.place_at(input, *wanted, weights) : face.place(weights);
  const Surface_point p = location_on_side(view, coordinates, h, weights[1]);
  if (!wanted) return face.place_on_side(input, p);
  if (wanted->halfedge / 2 != p.halfedge / 2) return std::nullopt;
  return face.place_on_side(input,
                            wanted->halfedge == p.halfedge ? *wanted : turned_around(*wanted));
}

} // namespace internal

/*!
\brief finds a place on the input for a new vertex in an intrinsic face, and the new lengths and
areas.

Barycentric coordinates in an input face are rounded to multiples of 2^-52, which then *define* the
vertex: all values at it, in any arithmetic, depend on the input alone. See `Unfolded_face`.
*/
class Insertion_placer {
public:
  /// Number type of values.
  using FT = Interval_nt<false>;

  /*!
  \brief places a vertex.
  \param t the triangulation; if its metric is exact, its scope is live
  \param coordinates a model of `CurveCoordinates`
  \param h a halfedge of the face
  \param weights barycentric coordinates, approximately; if the last one is zero, the vertex is on
    the side if that runs along an input edge, otherwise inside the face within rounding of the side
  \param wanted the place, if it is given
  \note For exact metrics, a place on a curve beyond a side is replaced by one beside the curve, and
  a point that rounding puts outside of the face is moved inwards: by less than 2^-28 of the height,
  or by less than 2^-44 of the longest side in thin faces, which have few representable points.
  \return the place; nothing if it is within rounding of a vertex, or, for exact metrics, not proven
  to be in the face
  */
  template <class Triangulation, CurveCoordinates Coordinates>
  std::optional<Placed_insertion> operator()(const Triangulation& t, const Coordinates& coordinates,
                                             std::uint32_t h, const std::array<double, 3>& weights,
                                             const std::optional<Surface_point>& wanted = {}) {
    const Intrinsic_view<Triangulation> view(t);
    const bool along_side = weights[2] == 0 && coordinates.normal_coordinate(h / 2) < 0;
    if constexpr (internal::Has_enclosures<typename Triangulation::Metric>) {
      forget_unfolded();
      face_.unfold(view, coordinates, h, values_of(coordinates.input()));
      if (along_side || !face_.is_vague()) {
        const auto p = place_near(face_, t, coordinates, h, weights, along_side, wanted);
        if (p || along_side) return p;
      }
      // intervals grow with the number of unfolded triangles, and their middles lose accuracy;
      // centers of balls only have rounding errors
      return internal::to_nearest([&] {
        unfold(short_, coordinates.input());
        return place_near(short_.face, t, coordinates, h, weights, along_side, wanted);
      });
    } else {
      const Input& input = coordinates.input();
      rough_.unfold(view, coordinates, h, approximate_values(input));
      return placed(internal::place_in(rough_, view, coordinates, h, weights, along_side, wanted),
                    along_side);
    }
  }

  /// returns how many steps were taken so far along curves that cross faces.
  std::size_t steps() const { return rough_.development().steps() + face_.development().steps(); }

  /// returns the values at the vertex that was placed last, if the metric of its triangulation is
  /// exact.
  const Vertex_move_values<FT>& values() const { return values_; }

  /// returns these values in 106 bits. \pre the face has not changed
  Vertex_move_values<Short_ball> short_values(const Input& input);

  /// returns the corner of the face with the most accurate direction from the last place, for such
  /// a metric; nothing if intervals are too wide to give a direction.
  /// \pre rounding is upwards, and the face has not changed
  std::optional<Seen_corner> seen_corner(const Input& input) const;

private:
  // distance of points of a side from it, in units of the height of the face
  static constexpr double nearness = 0x1p-40; // 16^3 of it are `usual_farthest`
  // Distance up to which they, and points that rounding puts outside, are moved into the face: a
  // sixteenth of rounding in single precision; in thin faces at most the largest power of two below
  // a third, the distance of the barycenter from all sides.
  static constexpr double usual_farthest = 0x1p-28, farthest_of_all = 0x1p-2;

  // in a thin face 2^-44 of the longest side
  template <class View>
  static double farthest(const View& view, std::uint32_t h) {
    const std::array<double, 3> l = squared_lengths_of_face(view, h);
    const double height =
        view.quadruple_area(view.face(h)) / (2 * *std::max_element(l.begin(), l.end()));
    return height * farthest_of_all > 0x1p-44 ? std::max(usual_farthest, 0x1p-44 / height)
                                              : farthest_of_all;
  }

  // The point moved inwards: in a thin face, where that is a large part of the height, at right
  // angles to the side.
  template <class View>
  static std::array<double, 3> beside(const View& view, std::uint32_t h,
                                      const std::array<double, 3>& w, double distance) {
    if (w[2] == 0 && distance > usual_farthest) {
      const double foot = apex_above_side(view, h).x; // of the height
      const std::array<double, 3> p{w[0] - distance * (1 - foot), w[1] - distance * foot, distance};
      if (p[0] > 0 && p[1] > 0) return p;
    }
    return inside(w, distance);
  }

  // the point, or one near it if sides of the face are near
  template <class Face, class Triangulation, class Coordinates>
  std::optional<Placed_insertion> place_near(const Face& face, const Triangulation& t,
                                             const Coordinates& coordinates, std::uint32_t h,
                                             const std::array<double, 3>& weights, bool along_side,
                                             const std::optional<Surface_point>& wanted) {
    const Intrinsic_view<Triangulation> view(t);
    if (wanted) {
      const auto p = internal::place_in(face, view, coordinates, h, weights, along_side, wanted);
      const bool is_there = p && is_in_face(t, coordinates.input(), *p, along_side);
      return is_there ? placed(p, along_side) : std::nullopt;
    }
    // a point of a side across input faces is usually not representable: one beside it is
    double distance = weights[2] == 0 && !along_side ? nearness : 0;
    const auto place_at_distance = [&] {
      return place_in_face(face, t, coordinates, h, beside(view, h, weights, distance), along_side);
    };
    if (const auto p = place_at_distance(); p || along_side) return p;
    const double last = farthest(view, h);
    if (*std::min_element(weights.begin(), weights.end()) >= last) return std::nullopt;
    while ((distance = std::max(16 * distance, nearness)) <= last)
      if (const auto p = place_at_distance()) return p;
    return std::nullopt;
  }

  // the point, or one nearby that has a distance from all sides
  static std::array<double, 3> inside(std::array<double, 3> w, double distance);

  // puts a point on a curve if that is in the face, else beside the curve
  template <class Face, class Triangulation, class Coordinates>
  std::optional<Placed_insertion>
  place_in_face(const Face& face, const Triangulation& t, const Coordinates& coordinates,
                std::uint32_t h, const std::array<double, 3>& weights, bool along_side) {
    const Input& input = coordinates.input();
    auto place = internal::place_in(face, Intrinsic_view<Triangulation>(t), coordinates, h, weights,
                                    along_side);
    if (place && is_in_face(t, input, *place, along_side)) return placed(place, along_side);
    if (!place || along_side || !place->region.is_on_curve) return std::nullopt;
    place = face.place(weights, Face::least_nearness);
    if (place && is_in_face(t, input, *place, false)) return placed(place, false);
    return std::nullopt;
  }

  // computes the values at a place; whether they are proven to be those of a point of the face
  template <class Triangulation>
  bool is_in_face(const Triangulation& t, const Input& input, const Place_in_face& place,
                  bool along_side) {
    const Protect_FPU_rounding<true> upwards(CGAL_FE_UPWARD);
    place_ = place;
    is_along_side_ = along_side;
    values_ = face_.values(place);
    if (along_side) values_.quadruple_areas[0] = FT(0);
    narrow_enclosures(106, 1024, [&](unsigned bits) {
      if (!is_open(along_side)) return true;
      const Mpfr_precision precision(bits);
      ++t.metric().statistics().sharpenings[bits];
      find_values(bits, input, along_side);
      return false;
    });
    return are_positive(along_side);
  }

  static std::optional<Placed_insertion> placed(const std::optional<Place_in_face>& p,
                                                bool along_side) {
    if (!p) return std::nullopt;
    return Placed_insertion{along_side, p->region, p->location};
  }

  // whether the values are those of a point of the face
  bool are_positive(bool along_side) const;
  // whether the values leave it open
  bool is_open(bool along_side) const;

  // balls with centers of a type; a copy of the placer unfolds faces anew, since these refer to its
  // own one
  template <class Center>
  struct Numbers {
    Numbers() = default;
    Numbers(const Numbers&) {}
    Numbers& operator=(const Numbers&) {
      is_unfolded = false;
      return *this;
    }

    Unfolded_face<Ball<Center>> face;
    Input_face_intervals<Ball<Center>> input;
    bool is_unfolded = false;
  };

  // the face that was unfolded last, in balls
  void forget_unfolded();

  // of faces of the input
  Unfolded_face<FT>::Values values_of(const Input& input);

  // rounding must be to the nearest
  template <class Center>
  void unfold(Numbers<Center>& numbers, const Input& input);

  // in more bits; if an area has no certain sign even there, the insertion is refused
  template <class Center>
  void find_values(Numbers<Center>& numbers, const Input& input, bool along_side);
  void find_values(unsigned bits, const Input& input, bool along_side);

  Unfolded_face<double> rough_;
  Unfolded_face<FT> face_;
  Input_face_intervals<FT> intervals_;
  Numbers<Double_double> short_;
  std::map<unsigned, Numbers<Mpfr_number>> long_; // by precision
  Vertex_move_values<FT> values_;
  Place_in_face place_; // that they belong to
  bool is_along_side_ = false;
};

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_CURVES_INSERTION_PLACER_H
