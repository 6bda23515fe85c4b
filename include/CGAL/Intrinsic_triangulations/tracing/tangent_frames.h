// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_TRACING_TANGENT_FRAMES_H
#define CGAL_INTRINSIC_TRIANGULATIONS_TRACING_TANGENT_FRAMES_H

#include <CGAL/Intrinsic_triangulations/connectivity/Gluing.h>
#include <CGAL/Intrinsic_triangulations/connectivity/concepts.h>
#include <CGAL/Intrinsic_triangulations/support/cmath.h>
#include <CGAL/Intrinsic_triangulations/tracing/geodesic_face.h>

#include <algorithm>
#include <cstdint>
#include <numbers>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/*!
\brief assigns tangent vectors at the vertices of a surface their coordinates (§2.4 of the course).

The halfedges from a vertex form a *fan*; a nonmanifold vertex has several. The first halfedge of a
fan is the reference direction: the one with the border on its right, if any. The *cone angle* of a
direction is the sum of the angles of the corners passed from there counterclockwise; the tangent
vector has the polar angle phi = 2 pi / Theta times the cone angle, scaled once, with Theta the sum
of all angles. At a border vertex the scale is pi / Theta, so that the vectors that point into the
surface fill a half-plane.
*/
class Tangent_frames {
public:
  /// The directions at a vertex, or at one fan of faces of a nonmanifold one.
  struct Fan {
    std::uint32_t begin; ///< slot of the first halfedge
    std::uint32_t size;  ///< number of halfedges
    double angle;        ///< Theta, the sum of the angles
    bool is_on_border;   ///< whether the vertex is on the border

    /// returns the factor from cone angles to polar angles.
    double scale() const {
      return angle > 0 ? (is_on_border ? 1 : 2) * std::numbers::pi / angle : 1;
    }
  };

  /// constructs no frames.
  Tangent_frames() = default;

  /*!
  \brief measures the angles of a surface.
  \tparam Complex a model of `NumberedComplex` with a function `number_of_halfedges()`
  \complexity linear
  */
  template <NumberedComplex Complex>
  explicit Tangent_frames(const Complex& complex)
      : fan_(complex.number_of_halfedges(), Gluing::none), slot_(fan_.size(), Gluing::none) {
    halfedge_.reserve(fan_.size());
    cone_angle_.reserve(fan_.size());
    for (std::uint32_t h = 0; h < fan_.size(); ++h)
      if (complex.is_border(h ^ 1U)) add_fan(complex, h);
    for (std::uint32_t h = 0; h < fan_.size(); ++h)
      if (fan_[h] == Gluing::none) add_fan(complex, h);
  }

  /// returns the number of fans.
  std::size_t number_of_fans() const { return fans_.size(); }
  /// returns the fan of halfedge `h`.
  std::uint32_t fan_of(std::uint32_t h) const { return fan_[h]; }
  /// returns a fan.
  const Fan& fan(std::uint32_t f) const { return fans_[f]; }
  /// returns the halfedge of a slot; those of a fan are consecutive, counterclockwise.
  std::uint32_t halfedge(std::uint32_t slot) const { return halfedge_[slot]; }
  /// returns the cone angle of halfedge `h` at its source.
  double cone_angle(std::uint32_t h) const { return cone_angle_[slot_[h]]; }
  /// returns the polar angle of halfedge `h` at its source.
  double polar_angle(std::uint32_t h) const { return fans_[fan_[h]].scale() * cone_angle(h); }

  /*!
  \brief finds the corner that a direction points into.
  \param fan a fan
  \param cone_angle the direction, between 0 and the angle of the fan
  \return a halfedge with a face, and the angle from it
  \complexity logarithmic in the degree
  */
  Corner_direction corner(std::uint32_t fan, double cone_angle) const {
    const Fan& f = fans_[fan];
    const auto begin = cone_angle_.begin() + f.begin;
    const auto after = std::upper_bound(begin, begin + f.size, cone_angle);
    std::uint32_t slot = f.begin + static_cast<std::uint32_t>(after - begin);
    if (slot > f.begin) --slot;
    if (f.is_on_border && slot + 1 == f.begin + f.size && f.size > 1) --slot;
    return {halfedge_[slot], std::max(0.0, cone_angle - cone_angle_[slot])};
  }

private:
  template <NumberedComplex Complex>
  void add_fan(const Complex& complex, std::uint32_t first) {
    const auto number = static_cast<std::uint32_t>(fans_.size());
    const auto begin = static_cast<std::uint32_t>(halfedge_.size());
    const Fan_angle all = measure_fan(complex, first, [&](std::uint32_t h, double angle) {
      fan_[h] = number;
      slot_[h] = static_cast<std::uint32_t>(halfedge_.size());
      halfedge_.push_back(h);
      cone_angle_.push_back(angle);
    });
    fans_.push_back(
        {begin, static_cast<std::uint32_t>(halfedge_.size()) - begin, all.sum, all.is_on_border});
  }

  std::vector<std::uint32_t> fan_;      // per halfedge
  std::vector<std::uint32_t> slot_;     // per halfedge
  std::vector<std::uint32_t> halfedge_; // per slot
  std::vector<double> cone_angle_;      // per slot
  std::vector<Fan> fans_;
};

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_TRACING_TANGENT_FRAMES_H
