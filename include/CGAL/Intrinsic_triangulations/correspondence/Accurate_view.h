// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_ACCURATE_VIEW_H
#define CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_ACCURATE_VIEW_H

#include <CGAL/Intrinsic_triangulations/correspondence/Intrinsic_view.h>
#include <CGAL/Intrinsic_triangulations/triangulation/Metric_values.h>

#include <cstdint>

namespace CGAL::Intrinsic_triangulations::internal {

// Views a triangulation; what it says of a thin face is as accurate as of any other, if traits are exact. In a face beside a
// very short edge the middle of the interval of an area may be far off, and the angle between the edge and a line with it.
template <class Triangulation>
class Accurate_view : public Intrinsic_view<Triangulation> {
  using Base = Intrinsic_view<Triangulation>;

public:
  explicit Accurate_view(const Triangulation& t) : Base(t), t_(&t) {}

  double squared_length(std::uint32_t e) const {
    sharpen(Base::face(this->is_border(2 * e) ? 2 * e + 1 : 2 * e));
    return Base::squared_length(e);
  }
  double quadruple_area(std::uint32_t f) const {
    sharpen(f);
    return Base::quadruple_area(f);
  }

private:
  void sharpen(std::uint32_t f) const { accurate_values(*t_, t_->numbers().face_at(f)); }

  const Triangulation* t_;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_ACCURATE_VIEW_H
