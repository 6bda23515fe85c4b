// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_triangulations/formulas/Diamond.h>
#include <CGAL/Intrinsic_triangulations/formulas/Face_values.h>
#include <CGAL/Intrinsic_triangulations/metric/Enclosed_values.h>
#include <CGAL/Intrinsic_triangulations/support/reserve_at_least.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

namespace internal {

namespace {

template <class T>
void set_value(std::vector<T>& values, std::uint32_t i, const T& value) {
  if (i >= values.size()) values.resize(i + 1);
  values[i] = value;
}

} // namespace

} // namespace internal

bool Enclosed_values::is_narrow(const Indexed_face& face, double width) const {
  const Face_values<FT> f = enclosure(face);
  double longest = 0;
  for (const FT& x : f.squared_lengths) {
    if (!is_narrow(x, width * x.sup())) return false;
    longest = std::max(longest, x.sup());
  }
  // zero never gets narrow relative to itself
  return is_narrow(f.quadruple_area, width * std::max(f.quadruple_area.sup(), 0x1p-1000 * longest));
}

void Enclosed_values::make_room(std::uint32_t edges, std::uint32_t faces) {
  reserve_at_least(squared_length_, edges);
  reserve_at_least(length_, edges);
  reserve_at_least(quadruple_area_, faces);
  reserve_at_least(area_, faces);
}

void Enclosed_values::store(std::span<const std::uint32_t> edges,
                            std::span<const std::uint32_t> faces, const New_values& n) noexcept {
  const auto& [enclosure, approximation] = n;
  for (std::size_t k = 0; k < edges.size(); ++k) {
    const std::uint32_t e = edges[k];
    internal::set_value(squared_length_, e, positive_part(enclosure.squared_lengths[k]));
    internal::set_value(length_, e, nearest(approximation.squared_lengths[k], squared_length_[e]));
  }
  for (std::size_t k = 0; k < faces.size(); ++k) {
    const std::uint32_t f = faces[k];
    internal::set_value(quadruple_area_, f, positive_part(enclosure.quadruple_areas[k]));
    internal::set_value(area_, f, nearest(approximation.quadruple_areas[k], quadruple_area_[f]));
  }
}

void Enclosed_values::refine(const Diamond& d, const Diamond_values<FT>& better) const {
  refine_length(d.ij, better.ij);
  refine_length(d.jk, better.jk);
  refine_length(d.ki, better.ki);
  refine_length(d.im, better.im);
  refine_length(d.mj, better.mj);
  refine_area(d.f, better.area_f);
  refine_area(d.g, better.area_g);
}

void Enclosed_values::refine(std::span<const Indexed_face> faces,
                             const std::vector<Face_values<FT>>& better) const {
  for (std::size_t i = 0; i < faces.size(); ++i) refine(faces[i], better[i]);
}

void Enclosed_values::refine(const Indexed_face& face, const Face_values<FT>& better) const {
  for (std::size_t k = 0; k < 3; ++k) refine_length(face.edges[k], better.squared_lengths[k]);
  refine_area(face.face, better.quadruple_area);
}

void Enclosed_values::refine(FT& stored, double& approximation, const FT& better) {
  // overflow makes a stored bound infinite or not a number
  const double inf = stored.inf() > better.inf() ? stored.inf() : better.inf();
  const double sup = stored.sup() < better.sup() ? stored.sup() : better.sup();
  stored = inf > sup ? better : FT(inf, sup); // apart only if a file had wrong digits
  approximation = nearest(approximation, stored);
}

} // namespace CGAL::Intrinsic_triangulations
