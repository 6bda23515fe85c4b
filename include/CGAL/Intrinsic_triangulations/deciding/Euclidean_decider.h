// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_DECIDING_EUCLIDEAN_DECIDER_H
#define CGAL_INTRINSIC_TRIANGULATIONS_DECIDING_EUCLIDEAN_DECIDER_H

#include <CGAL/Intrinsic_triangulations/correspondence/models/Integer_coordinates.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/Vertex_places.h>
#include <CGAL/Intrinsic_triangulations/deciding/Exact_memory.h>
#include <CGAL/Intrinsic_triangulations/deciding/Figure_finder.h>
#include <CGAL/Intrinsic_triangulations/deciding/Followed_values.h>
#include <CGAL/Intrinsic_triangulations/exact/Exact_ladder.h>
#include <CGAL/Intrinsic_triangulations/exact/Predicate_statistics.h>
#include <CGAL/Intrinsic_triangulations/exact/numbers/Ball.h>
#include <CGAL/Intrinsic_triangulations/exact/numbers/Mpfr_number.h>
#include <CGAL/Intrinsic_triangulations/exact/unfolding/Flip_list.h>
#include <CGAL/Intrinsic_triangulations/exact/unfolding/Replayed_faces.h>
#include <CGAL/Intrinsic_triangulations/exact/unfolding/figures.h>
#include <CGAL/Intrinsic_triangulations/formulas/Diamond.h>
#include <CGAL/Intrinsic_triangulations/formulas/Face_values.h>
#include <CGAL/Intrinsic_triangulations/formulas/Recorded_expression.h>
#include <CGAL/Intrinsic_triangulations/metric/Enclosed_values.h>
#include <CGAL/Intrinsic_triangulations/triangulation/Metric_values.h>

#include <CGAL/Interval_nt.h>
#include <CGAL/enum.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

/*
Decides for a metric that stores enclosures: asks the metric first. What that leaves open it decides
exactly on the figure of the values, and gives the metric the narrower enclosures found on the way.
*/
template <class Triangulation, class Places = Vertex_places<Triangulation>>
class Euclidean_decider : public Figure_finder<Triangulation, Places> {
  using Base = Figure_finder<Triangulation, Places>;
  using Metric = typename Triangulation::Metric;

public:
  using FT = Interval_nt<false>;
  using Base::Base;

  // The sign of an expression in the values of a diamond, and of faces.
  template <class Expression>
  Sign sign(const Diamond& d, const Expression& expression) const {
    const std::optional<Sign> s = metric().certain_sign(d, expression);
    return s ? *s : open_sign(d, recorded(expression));
  }
  template <class Expression>
  Sign sign(std::span<const Indexed_face> faces, const Expression& expression) const {
    const std::optional<Sign> s = metric().certain_sign(faces, expression);
    return s ? *s : open_sign(faces, Recorded_face_expression(expression, faces.size()));
  }
  // whether the angles opposite the edge sum to at most pi, which stored intervals leave open
  bool is_open_delaunay(const Diamond& d) const {
    return open_sign(d, recorded(Delaunay_expression())) != NEGATIVE;
  }

  // see `Predicate_session::cotangent_weight()`
  double cotangent_weight(const Diamond& d, double tolerance) const {
    if (const auto weight = metric().stored_weight(d, tolerance)) return *weight;
    if (!memory_.are_found && asks_for_all()) {
      // a query must not end that values follow flips
      if (!memory_.values.follows_flips()) find_values(inaccurate_diamonds());
      memory_.are_found = true;
    }
    if (const auto weight = replayed_weight(d)) return *weight;
    if (const auto weight = metric().stored_weight(d)) return *weight;
    // Users get the nearest double, which does not depend on the way of computation. Statistics
    // allow an error, so that angles near 1e-9 need no more than 106 bits, and mostly no sign.
    const double error = tolerance > Enclosed_values::weight_tolerance ? tolerance : 0;
    if (error > 0)
      if (const auto weight = this->weight_on_figure(d, error, 106)) return *weight;
    if (sign(d, Delaunay_expression()) == ZERO) return 0;
    if (!can_unfold_soon()) {
      ++memory_.passes;
      if (const auto weight = this->weight_by_few_flips(d)) return *weight;
    }
    return *this->weight_on_figure(d, error, Mpfr_number::most_bits);
  }

  // Finds at once, where that takes less time, what the weights of many diamonds take that stored
  // values leave open, and that will be asked for.
  void expect_weights(std::span<const Diamond> open) const {
    if (open.empty() || memory_.are_found || places_.flips() == nullptr) return;
    if (!memory_.values.follows_flips()) find_values(open);
    memory_.are_found = true;
  }

  // Makes stored intervals of faces narrow, and the doubles beside them accurate: to 2^-41 of the
  // value, except for areas of thin faces, which get as accurate as `most_bits` allow. Those of all
  // faces, once single ones have taken as long.
  void sharpen(std::span<const Indexed_face> faces) const {
    if (asks_for_faces()) sharpen_all();
    narrow({faces.begin(), faces.end()});
  }
  // the same for the interval of the squared length of the first side of a face
  void sharpen_length(const Indexed_face& face) const {
    if (asks_for_faces()) sharpen_all();
    const std::uint32_t e = face.edges[0];
    narrow_enclosures(53, most_bits, [&](unsigned bits) {
      if (metric().is_narrow(e)) return true;
      ++metric().statistics().sharpenings[bits];
      metric().refine_length(e, first_squared_length(face, bits));
      return false;
    });
  }

  // Calls a function with the number of each face and intervals that contain its values, computed
  // in at least `bits` bits: 106 or more if flips are repeated, since repeating them in doubles
  // would only give the stored intervals again.
  template <class Visit>
  void for_each_enclosure(std::span<const Indexed_face> faces, unsigned bits,
                          const Visit& visit) const {
    if (repeats_flips(faces))
      repeat_flips(faces, std::max(bits, 106U), visit);
    else
      unfold(faces, bits, visit);
  }

  // Lets values in 106 bits follow all further flips, and gives the metric those that it has now.
  // Called before a flip: what it stores depends on moves, not on queries.
  void follow_flips() const {
    if (places_.flips() == nullptr) return;
    const std::vector<Indexed_face> all = this->all_faces();
    memory_.values.keep(this->replayed_values(all), true);
    memory_.values.refine(metric(), all);
  }

  // Lets values in 106 bits follow an insertion that was announced, around needles: see
  // `Followed_values`.
  void follow_insertion() const {
    Followed_values& values = memory_.values;
    if (!values.follows_insertions() && places_.flips() != nullptr && this->has_long_turns())
      values.follow_insertions(this->replayed_values(this->all_faces()));
    if (values.follows_insertions())
      values.announce(*places_.coordinates(t_), t_.numbers().edge_capacity(t_.mesh()) + 3,
                      t_.numbers().face_capacity(t_.mesh()) + 2);
  }
  // Gives the metric the values that follow insertions, of faces whose stored ones are too wide.
  void take_followed(double width) const {
    if (memory_.values.follows_insertions())
      metric().statistics().sharpenings[106] +=
          memory_.values.refine(metric(), this->wide_faces(width));
  }

private:
  // Areas count down to 2^-1000 of squared lengths (`Enclosed_values::is_narrow()`), which takes
  // 1,041 bits and those that unfolding loses, or flips, which lose more.
  static constexpr unsigned most_bits = 4096;
  // These numbers bound the time at worst. On the data set it is the same, within noise, with a
  // quarter of each and with four times as many.
  static constexpr unsigned few_passes = 4;            // without coordinates
  static constexpr std::size_t flips_per_step = 4;     // before a pass
  static constexpr std::size_t steps_per_crossing = 8; // of a pass over all faces

  const Metric& metric() const { return t_.metric(); }

  // a sign that the stored intervals leave open
  Sign open_sign(const Diamond& d, const Recorded_diamond_expression& expression) const {
    Predicate_statistics& statistics = metric().statistics();
    ++statistics.filter_failures;
    std::uint64_t& probable = statistics.probable_zero;
    const bool is_remembered = expression.zero_meaning() == Zero_meaning::cocircular;
    if (is_remembered)
      if (const auto known = metric().remembered_signs().find(d.ij)) {
        if (known->sign == ZERO) ++(known->is_probable ? probable : statistics.certified_zero);
        return known->sign;
      }
    const std::uint64_t before = probable;
    const std::optional<Sign> turned = this->turned_sign(d, expression);
    Diamond_values<FT> better = metric().enclosure(d);
    const Sign s = turned ? *turned : this->exact_sign(d, expression, better);
    metric().refine(d, better);
    if (is_remembered) metric().remembered_signs().remember(d.ij, {s, probable != before});
    return s;
  }
  Sign open_sign(std::span<const Indexed_face> faces,
                 const Recorded_face_expression& expression) const {
    ++metric().statistics().filter_failures;
    std::vector<Face_values<FT>> better = metric().enclosures(faces);
    const Sign s = this->exact_sign(faces, expression, better);
    metric().refine(faces, better);
    return s;
  }

  // Errors grow with each flip that is repeated, while those of unfolded triangles only add up. So
  // flips are repeated in 106 bits, and where that is not enough, unfolding starts with doubles.
  void narrow(std::vector<Indexed_face> wide) const {
    const auto are_narrow = [&] {
      std::erase_if(wide, [this](const Indexed_face& f) { return metric().is_narrow(f); });
      return wide.empty();
    };
    const auto refine = [&](std::size_t i, const Face_values<FT>& better) {
      metric().refine(wide[i], better);
    };
    const auto count = [&](unsigned bits) {
      metric().statistics().sharpenings[bits] += wide.size();
    };
    if (are_narrow()) return;
    Followed_values& values = memory_.values;
    if (!values.is_following() && !values.are_known(wide) && repeats_flips(wide))
      values.keep(this->replayed_values(wide), false);
    if (!values.follows_insertions() && values.are_known(wide))
      metric().statistics().sharpenings[106] += values.refine(metric(), wide);
    narrow_enclosures(53, most_bits, [&](unsigned bits) {
      if (are_narrow()) return true;
      const bool is_unfolded = this->can_unfold(wide, triangles_per_long_flip);
      if (!is_unfolded && bits <= 106) return false; // flips were repeated in these
      count(bits);
      if (is_unfolded)
        unfold(wide, bits, refine);
      else
        repeat_flips(wide, bits, refine);
      return false;
    });
  }

  // whether to compute values of faces from flips that are repeated, all at once
  bool repeats_flips(std::span<const Indexed_face> faces) const {
    return (asks_for_faces() && !can_unfold_soon()) || !this->can_unfold(faces);
  }
  template <class Visit>
  void repeat_flips(std::span<const Indexed_face> faces, unsigned bits, const Visit& visit) const {
    memory_.ladder.for_each_enclosure(this->input_metric(), this->replayed(faces), bits, visit);
  }
  // or from the input triangles under each: there may be thousands
  template <class Visit>
  void unfold(std::span<const Indexed_face> faces, unsigned bits, const Visit& visit) const {
    for (std::size_t i = 0; i < faces.size(); ++i) {
      const std::optional<Face_values<FT>> turned = this->turned_values(faces[i], bits);
      visit(i, turned ? *turned : enclosure(this->unfolded(faces.subspan(i, 1)), bits));
    }
  }
  void sharpen_all() const {
    std::vector<Indexed_face> wide = this->wide_faces();
    note_crossings();
    narrow(std::move(wide));
    memory_.are_sharp = true;
    count_pass();
  }

  // Finds values for diamonds whose stored values are too inaccurate for weights, by repeating
  // flips, if that takes less time than one by one. It also finds those of all faces with wide
  // intervals, which are usually asked for next, but leaves the stored ones: weights must not
  // depend on the order in which they are asked for.
  void find_values(std::span<const Diamond> diamonds) const {
    note_crossings();
    count_pass();
    if (memory_.values.is_following()) return;
    std::vector<Indexed_face> faces;
    faces.reserve(2 * diamonds.size());
    for (const Diamond& d : diamonds)
      for (const Indexed_face& f : this->faces_of(d)) faces.push_back(f);
    if (places_.has_coordinates(t_) && this->can_unfold(faces)) return;
    const std::vector<Indexed_face> wide = this->wide_faces();
    faces.insert(faces.end(), wide.begin(), wide.end());
    memory_.values.keep(this->replayed_values(faces), false);
  }
  std::vector<Diamond> inaccurate_diamonds() const {
    const auto& mesh = t_.mesh();
    const auto null = boost::graph_traits<typename Triangulation::Mesh>::null_face();
    std::vector<Diamond> result;
    for (const auto e : edges(mesh)) {
      const auto h = halfedge(e, mesh);
      if (face(h, mesh) == null || face(opposite(h, mesh), mesh) == null) continue;
      const Diamond d = t_.diamond(h);
      if (!metric().stored_weight(d) && !metric().remembered_signs().is_zero(d.ij))
        result.push_back(d);
    }
    return result;
  }
  // the double nearest to the weight of a diamond, if values in 106 bits are there and tell it
  std::optional<double> replayed_weight(const Diamond& d) const {
    const Replayed_values<Short_ball>* const values = memory_.values.of(d);
    if (values == nullptr) return std::nullopt;
    const std::optional<double> weight = Exact_ladder::nearest_weight(values->values(d));
    if (weight) ++metric().statistics().sharpenings[106];
    return weight;
  }

  // an interval of the squared length of the first side of a face, from at least `bits` bits
  FT first_squared_length(const Indexed_face& face, unsigned bits) const {
    if (const auto* values = memory_.values.of(face); values != nullptr && bits <= 106)
      return values->length(face.edges[0]).interval();
    if (this->can_unfold(std::array{face.edges[0]}))
      return memory_.ladder.squared_length(this->input_metric(), this->strip(face), bits);
    return enclosure(this->replayed(std::span(&face, 1)), std::max(bits, 106U))
        .squared_lengths.front();
  }
  // of one face
  Face_values<FT> enclosure(const Unfolded_faces& face, unsigned bits) const {
    return memory_.ladder.enclosures(this->input_metric(), face, bits).front();
  }
  Face_values<FT> enclosure(const Replayed_faces& face, unsigned bits) const {
    Face_values<FT> result;
    memory_.ladder.for_each_enclosure(this->input_metric(), face, bits,
                                      [&](std::size_t, const auto& values) { result = values; });
    return result;
  }

  // Whether to compute values of all faces at once: if single ones have taken as long, or there is
  // nothing to unfold yet.
  bool asks_for_faces() const { return !memory_.are_sharp && asks_for_all(); }
  bool asks_for_all() const {
    if (const Flip_list* flips = places_.flips())
      return !can_unfold_soon() || memory_.steps > flips->size() / flips_per_step;
    // where vertices were inserted: as many steps as one pass along the input edges takes, and one
    // over all triangles under faces
    if (memory_.steps <= memory_.enough_steps) return false;
    const Integer_coordinates& c = *places_.coordinates(t_);
    if (memory_.steps <= c.number_of_edges()) return false;
    memory_.enough_steps = c.number_of_edges();
    for (std::uint32_t e = 0; e < c.number_of_edges(); ++e)
      memory_.enough_steps += steps_per_crossing * number_of_crossings(c, e);
    return memory_.steps > memory_.enough_steps;
  }
  // whether there are coordinates, or it pays to make some, which follow moves
  bool can_unfold_soon() const {
    return places_.has_coordinates(t_) || memory_.passes > few_passes;
  }
  // of all edges, in one pass along the input edges; repeats the flips if they are listed
  void note_crossings() const {
    memory_.unfolder.take_steps(); // else these would count against storing crossings
    if (places_.flips() == nullptr) places_.coordinates(t_)->keep_crossings(t_);
  }
  void count_pass() const {
    memory_.steps = memory_.enough_steps = 0;
    ++memory_.passes;
  }

  using Base::memory_;
  using Base::places_;
  using Base::t_;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_DECIDING_EUCLIDEAN_DECIDER_H
