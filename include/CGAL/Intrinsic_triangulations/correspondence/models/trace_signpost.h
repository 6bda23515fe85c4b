// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_MODELS_TRACE_SIGNPOST_H
#define CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_MODELS_TRACE_SIGNPOST_H

#include <CGAL/Intrinsic_triangulations/connectivity/Gluing.h>
#include <CGAL/Intrinsic_triangulations/correspondence/Intrinsic_view.h>
#include <CGAL/Intrinsic_triangulations/tracing/geodesic_to_target.h>

#include <cmath>
#include <cstdint>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

namespace internal {

// Traces from the source; once more in a corrected direction if the target was met by a bent line.
template <class View, class Signposts>
Geodesic_to_target follow_signpost(const View& view, const Signposts& signposts, std::uint32_t h,
                                   std::vector<Strip_side>& strip) {
  const double length = std::sqrt(view.squared_length(h / 2));
  const Geodesic_target target = signposts.target(view.target(h));
  Geodesic_to_target r;
  double turn = 0;
  for (int i = 0; i < 3 && !r.is_reached; ++i) {
    r = trace_to_target(signposts.input(), signposts.walk(h, turn), target, length, strip);
    if (!(r.length > 0)) break;
    turn += std::atan(r.slope);
  }
  return r;
}

} // namespace internal

/*!
\brief traces an intrinsic halfedge over the input (§3.4.1).

If it cannot be traced from its source, it is traced from its target.
\tparam Triangulation an instance of `Intrinsic_triangulation`
\param t the triangulation
\param signposts its signposts
\param h a halfedge, by its number
\param crossings the input edges that it crosses are appended to it, in order
\param strip space for the trace
\return whether it was traced to its end, whether that is certain, and the input halfedge that it runs
  along, in the same direction, if there is one
\complexity linear in the number of crossings
*/
template <class Triangulation, class Signposts>
Geodesic_to_target trace_signpost(const Triangulation& t, const Signposts& signposts,
                                  std::uint32_t h, std::vector<Geodesic_crossing>& crossings,
                                  std::vector<Strip_side>& strip) {
  const Intrinsic_view<Triangulation> view(t);
  Geodesic_to_target r = internal::follow_signpost(view, signposts, h, strip);
  if (r.is_reached) {
    for (const Strip_side& s : strip) crossings.push_back({s.halfedge, s.parameter(r.slope)});
    return r;
  }
  r = internal::follow_signpost(view, signposts, h ^ 1U, strip);
  if (!r.is_reached) return r;
  for (auto s = strip.rbegin(); s != strip.rend(); ++s)
    crossings.push_back({s->halfedge ^ 1U, 1 - s->parameter(r.slope)});
  if (r.along != Gluing::none) r.along ^= 1U;
  return r;
}

/// traces an intrinsic halfedge over the input, see above.
template <class Triangulation, class Signposts>
Geodesic_to_target trace_signpost(const Triangulation& t, const Signposts& signposts,
                                  std::uint32_t h, std::vector<Geodesic_crossing>& crossings) {
  std::vector<Strip_side> strip;
  return trace_signpost(t, signposts, h, crossings, strip);
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_MODELS_TRACE_SIGNPOST_H
