// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_triangulations/correspondence/models/Integer_coordinates.h>
#include <CGAL/Intrinsic_triangulations/deciding/Followed_values.h>
#include <CGAL/Intrinsic_triangulations/exact/numbers/Ball.h>
#include <CGAL/Intrinsic_triangulations/exact/numbers/Double_double.h>
#include <CGAL/Intrinsic_triangulations/exact/unfolding/Replayed_faces.h>
#include <CGAL/Intrinsic_triangulations/formulas/Diamond.h>
#include <CGAL/Intrinsic_triangulations/formulas/Face_values.h>
#include <CGAL/Intrinsic_triangulations/formulas/Vertex_star.h>
#include <CGAL/Intrinsic_triangulations/metric/Enclosed_values.h>
#include <CGAL/Intrinsic_triangulations/triangulation/Moves.h>

#include <CGAL/Interval_nt.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>

namespace CGAL::Intrinsic_triangulations::internal {

namespace {

// whether an interval is wider than users allow
bool is_too_wide(const Interval_nt<false>& x) {
  return !(x.sup() - x.inf() <= Enclosed_values::narrow * x.sup());
}

// \pre rounding is upwards
Short_ball ball_around(const Interval_nt<false>& x) {
  const double center = x.inf() / 2 + x.sup() / 2;
  return Short_ball::around(center, std::max(x.sup() - center, center - x.inf()));
}

Vertex_move_values<Short_ball> short_values_at_vertex(const Integer_coordinates& c) {
  const auto& [lengths, areas] = c.inserted_values();
  if (std::any_of(lengths.begin(), lengths.end(), is_too_wide) ||
      std::any_of(areas.begin(), areas.end(), is_too_wide))
    return c.inserted_short_values();
  Vertex_move_values<Short_ball> result;
  std::transform(lengths.begin(), lengths.end(), result.squared_lengths.begin(), ball_around);
  std::transform(areas.begin(), areas.end(), result.quadruple_areas.begin(), ball_around);
  return result;
}

} // namespace

bool Followed_values::are_known(std::span<const Indexed_face> faces) const {
  return std::all_of(faces.begin(), faces.end(),
                     [this](const Indexed_face& f) { return of(f) != nullptr; });
}

std::size_t Followed_values::refine(const Enclosed_values& metric,
                                    std::span<const Indexed_face> faces) const {
  std::size_t count = 0;
  for (const Indexed_face& f : faces) {
    if (of(f) == nullptr) continue;
    ++count;
    for (const std::uint32_t e : f.edges) metric.refine_length(e, values_->length(e).interval());
    metric.refine_area(f.face, values_->area(f.face).interval());
  }
  return count;
}

void Followed_values::follow_insertions(Replayed_values<Short_ball> values) {
  if (!values.are_narrow(Enclosed_values::narrow)) return forget();
  values_ = std::move(values);
  following_ = Following::insertions;
}

void Followed_values::announce(const Integer_coordinates& coordinates, std::uint32_t edges,
                               std::uint32_t faces) {
  values_->make_room(edges, faces);
  inserted_ = short_values_at_vertex(coordinates);
}

// Errors of `flipped()` are those of any rounding: a change of rounding takes longer.
void Followed_values::follow(const Enclosed_values& metric, const Flip& move) noexcept {
  const Diamond& d = move.diamond;
  if (following_ == Following::nothing || (follows_flips() && move.is_taken_back()))
    return forget();
  Flipped_values<Short_ball> n = flipped(values_->values(d), 4 * Double_double::rounding());
  if (move.is_taken_back()) std::swap(n.area_f, n.area_g); // mk is on the left of ij, not km
  values_->store(d, n);
  if (follows_insertions()) return;
  metric.refine_length(d.ij, n.km.interval());
  metric.refine_area(d.f, n.area_f.interval());
  metric.refine_area(d.g, n.area_g.interval());
}

void Followed_values::insert(const Vertex_star& star) noexcept {
  if (!follows_insertions()) return forget();
  for (std::size_t k = 0; k < 3; ++k) {
    values_->set_length(star.spokes[k], inserted_.squared_lengths[k]);
    values_->set_area(star.faces[k], inserted_.quadruple_areas[k]);
  }
}

void Followed_values::insert(const Border_star& star) noexcept {
  if (!follows_insertions()) return forget();
  const auto& [lengths, areas] = inserted_;
  values_->set_length(star.ip, lengths[0]);
  values_->set_length(star.pj, lengths[1]);
  values_->set_length(star.pk, lengths[2]);
  values_->set_area(star.f, areas[2]);
  values_->set_area(star.g, areas[1]);
}

void Followed_values::remove(const Vertex_star& star) noexcept {
  if (!follows_insertions()) return forget();
  const auto area = [&](std::size_t k) { return values_->area(star.faces[k]); };
  values_->set_area(star.faces[0], to_nearest([&] { return area(0) + area(1) + area(2); }));
}

void Followed_values::remove(const Border_star& star) noexcept {
  if (!follows_insertions()) return forget();
  const Diamond d{star.pk, star.ki, star.ip, star.pj, star.jk, star.f, star.g};
  const auto n = to_nearest([&] { return removed_from_border_edge(values_->values(d)); });
  values_->set_length(star.ip, n.km);
  values_->set_area(star.f, n.area_f);
}

void Followed_values::forget() noexcept {
  following_ = Following::nothing;
  values_.reset();
}

} // namespace CGAL::Intrinsic_triangulations::internal
