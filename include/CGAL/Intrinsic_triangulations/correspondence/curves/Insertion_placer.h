// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_CURVES_INSERTION_PLACER_H
#define CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_CURVES_INSERTION_PLACER_H

#include <CGAL/Intrinsic_triangulations/correspondence/Intrinsic_view.h>
#include <CGAL/Intrinsic_triangulations/correspondence/curves/Face_region.h>
#include <CGAL/Intrinsic_triangulations/correspondence/curves/Unfolded_face.h>
#include <CGAL/Intrinsic_triangulations/exact/Input_face_intervals.h>
#include <CGAL/Intrinsic_triangulations/exact/numbers/Ball.h>
#include <CGAL/Intrinsic_triangulations/exact/numbers/Double_double.h>
#include <CGAL/Intrinsic_triangulations/formulas/Face_values.h>
#include <CGAL/Intrinsic_triangulations/formulas/Vertex_star.h>
#include <CGAL/Intrinsic_triangulations/input/Input.h>
#include <CGAL/Intrinsic_triangulations/triangulation/Surface_point.h>
#include <CGAL/Intrinsic_triangulations/triangulation/concepts.h>

#include <CGAL/Interval_nt.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <type_traits>

namespace CGAL::Intrinsic_triangulations {

/// tells where a vertex that is to be inserted lies.
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

template <class U, class View, class Coordinates, class Values>
auto place_with(U& face, const View& view, const Coordinates& coordinates, std::uint32_t h,
                const std::array<double, 3>& weights, bool along_side, const Values& values) {
  face.unfold(view, coordinates, h, values);
  return along_side ? face.place_on_side(coordinates.input(),
                                         location_on_side(view, coordinates, h, weights[1]))
                    : face.place(coordinates.input(), weights);
}

} // namespace internal

/*!
\brief finds a place on the input for a vertex that is to be inserted in an intrinsic face, and what lengths and areas
that place makes.

Barycentric coordinates in an input face are rounded to multiples of 2^-52, which then *define* the vertex: all that
follows from it, in whatever arithmetic, depends on the input alone. See `Unfolded_face`.
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
  \param weights barycentric coordinates, approximately; if the last one is zero, the vertex will be on the side, if
  that runs along an input edge, else within rounding of it, inside the face
  \note For exact metrics a place on a curve beyond a side is replaced by one beside the curve, and a point that
  rounding puts outside of the face is moved inwards, up to 2^-28 of the height.
  \return the place; nothing if it is within rounding of a vertex, or, for exact metrics, not proven to be in the face
  */
  template <class Triangulation, CurveCoordinates Coordinates>
  std::optional<Placed_insertion> operator()(const Triangulation& t, const Coordinates& coordinates,
                                             std::uint32_t h,
                                             const std::array<double, 3>& weights) {
    const bool along_side = weights[2] == 0 && coordinates.normal_coordinate(h / 2) < 0;
    if constexpr (internal::Defined_by_places<typename Triangulation::Metric>) {
      // a point of a side that runs across input faces cannot be represented, as a rule: one beside it can
      double distance = weights[2] == 0 && !along_side ? nearness : 0;
      const bool is_near_side = *std::min_element(weights.begin(), weights.end()) < farthest;
      for (; distance <= farthest; distance = std::max(16 * distance, nearness)) {
        const auto p = place_in_face(t, coordinates, h, inside(weights, distance), along_side);
        if (p || along_side || !is_near_side) return p;
      }
      return std::nullopt;
    } else {
      const Input& input = coordinates.input();
      return placed(internal::place_with(rough_, Intrinsic_view<Triangulation>(t), coordinates, h,
                                         weights, along_side, approximate_values(input)),
                    along_side);
    }
  }

  /// returns the values at the vertex that was placed last, if the metric of its triangulation is exact.
  const Vertex_move_values<FT>& values() const { return values_; }

private:
  // distance of points of a side from it, in units of the height of the face
  static constexpr double nearness = 0x1p-40;
  // distance up to which they, and points that rounding puts outside, are moved into the face
  static constexpr double farthest = 0x1p-28;

  // the point, or one nearby that has a distance from all sides
  static std::array<double, 3> inside(std::array<double, 3> w, double distance) {
    double before = 0, after = 0; // of the weights that are raised
    for (double& x : w)
      if (x < distance) before += x, after += distance;
    for (double& x : w)
      x = x < distance ? distance : after > 0 ? x * ((1 - after) / (1 - before)) : x;
    return w;
  }

  // where a point is put on a curve if that is in the face, else beside the curve
  template <class Triangulation, class Coordinates>
  std::optional<Placed_insertion>
  place_in_face(const Triangulation& t, const Coordinates& coordinates, std::uint32_t h,
                const std::array<double, 3>& weights, bool along_side) {
    const Input& input = coordinates.input();
    auto place = internal::place_with(face_, Intrinsic_view<Triangulation>(t), coordinates, h,
                                      weights, along_side,
                                      internal::values_from(input, intervals_.of(input.metric())));
    if (place && is_in_face(t, coordinates, h, *place, along_side))
      return placed(place, along_side);
    if (!place || along_side || !place->region.is_on_curve) return std::nullopt;
    place = face_.place(input, weights, Unfolded_face<FT>::least_nearness);
    if (place && is_in_face(t, coordinates, h, *place, false)) return placed(place, false);
    return std::nullopt;
  }

  // computes the values at a place; whether they are proven to be those of a point of the face
  template <class Triangulation, class Coordinates, class Place>
  bool is_in_face(const Triangulation& t, const Coordinates& coordinates, std::uint32_t h,
                  const Place& place, bool along_side) {
    values_ = face_.values(place);
    if (along_side) values_.quadruple_areas[0] = FT(0);
    if (are_positive(values_, along_side)) return true;
    for (const FT& area : values_.quadruple_areas)
      if (area.sup() < 0) return false;
    const Intrinsic_view<Triangulation> view(t);
    const auto is_proven_in = [&](auto& numbers) {
      ++t.metric().statistics().sharpenings[std::decay_t<decltype(numbers)>::bits];
      return find_values(numbers, view, coordinates, h, place, along_side);
    };
    return is_proven_in(short_) || is_proven_in(long_);
  }

  template <class Place>
  static std::optional<Placed_insertion> placed(const std::optional<Place>& p, bool along_side) {
    if (!p) return std::nullopt;
    return Placed_insertion{along_side, p->region, p->location};
  }

  static bool are_positive(const Vertex_move_values<FT>& v, bool along_side) {
    for (std::size_t k = 0; k < 3; ++k)
      if (!(v.squared_lengths[k].inf() > 0) ||
          (!(v.quadruple_areas[k].inf() > 0) && !(along_side && k == 0)))
        return false;
    return true;
  }

  // balls with centers of a type
  template <class Center>
  struct Numbers {
    static constexpr unsigned bits = Ball<Center>::bits;
    Unfolded_face<Ball<Center>> face;
    Input_face_intervals<Ball<Center>> input;
  };

  // in more bits; an area that shows no sign in 256 is not worth an insertion
  template <class Center, class View, class Coordinates, class Place>
  bool find_values(Numbers<Center>& numbers, const View& view, const Coordinates& coordinates,
                   std::uint32_t h, const Place& place, bool along_side) {
    const Input& input = coordinates.input();
    const Vertex_move_values<Ball<Center>> wide = internal::to_nearest([&] {
      numbers.face.unfold(view, coordinates, h,
                          internal::values_from(input, numbers.input.of(input.metric())));
      return numbers.face.values({place.region, place.triangle, place.weights, place.location});
    });
    for (std::size_t k = 0; k < 3; ++k) {
      values_.squared_lengths[k] = wide.squared_lengths[k].interval();
      if (!along_side || k > 0) values_.quadruple_areas[k] = wide.quadruple_areas[k].interval();
    }
    return are_positive(values_, along_side);
  }

  Unfolded_face<double> rough_;
  Unfolded_face<FT> face_;
  Input_face_intervals<FT> intervals_;
  Numbers<Double_double> short_;
  Numbers<Mpfr_256> long_;
  Vertex_move_values<FT> values_;
};

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_CURVES_INSERTION_PLACER_H
