// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_simplification/isometry/Isometry_run.h>
#include <CGAL/Intrinsic_simplification/isometry/find_isometries.h>
#include <CGAL/Intrinsic_simplification/isometry/search/Isometry_search.h>
#include <CGAL/Intrinsic_triangulations/triangulation/Surface_point.h>

#include <algorithm>
#include <cstddef>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

const char* name_of(Isometry_answer answer) {
  switch (answer) {
  case Isometry_answer::isometric:
    return "isometric";
  case Isometry_answer::isometric_within:
    return "isometric_within";
  case Isometry_answer::not_isometric:
    return "not_isometric";
  case Isometry_answer::undecided:
    break;
  }
  return "undecided";
}

Isometry::Isometry(std::shared_ptr<const internal::Isometry_search> search, std::size_t number)
    : search_(std::move(search)) {
  search_->compute(number, *this);
}

bool Isometry::reverses_orientation() const {
  return std::any_of(is_mirrored_.begin(), is_mirrored_.end(), [](char m) { return m != 0; });
}

std::vector<Surface_point> Isometry::images_of(std::span<const Surface_point> points) const {
  return search_->images(*this, points);
}

Isometry_answer Isometries::answer() const { return search_->answer(); }
double Isometries::count() const { return search_->count(); }
std::size_t Isometries::size() const {
  return static_cast<std::size_t>(std::min(search_->count(), 0x1p32));
}
Isometry Isometries::operator[](std::size_t i) const {
  return internal::Isometry_search::isometry(search_, i);
}
double Isometries::largest_difference() const { return search_->largest_difference(); }
std::string Isometries::note() const { return search_->note(); }
std::size_t Isometries::number_of_walks() const { return search_->number_of_walks(); }

Isometries find_isometries(const Canonical_form& a, const Canonical_form& b,
                           const Isometry_options& options) {
  internal::Isometry_run run(options);
  return Isometries(
      std::make_shared<const internal::Isometry_search>(a.shared_parts(), b.shared_parts(), run));
}

} // namespace CGAL::Intrinsic_triangulations
