// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_simplification/isometry/Canonical_form.h>
#include <CGAL/Intrinsic_simplification/isometry/Singular_surface.h>
#include <CGAL/Intrinsic_simplification/isometry/hash_of_surface.h>
#include <CGAL/Intrinsic_triangulations/input/Input.h>
#include <CGAL/Intrinsic_triangulations/metric/Exact_euclidean_traits.h>

#include <cmath>
#include <cstdint>
#include <memory>
#include <string>
#include <utility>

namespace CGAL::Intrinsic_triangulations {

namespace {

std::shared_ptr<const internal::Singular_surface> parts_of(Corresponding_triangulation t) {
  return std::make_shared<const internal::Singular_surface>(
      std::move(t), internal::Tessellation_vertices::not_flat);
}

Corresponding_triangulation triangulation_of(std::shared_ptr<const Input> surface) {
  Exact_euclidean_metric metric(surface->mesh(), surface->metric());
  Gluing_map mesh = surface->mesh();
  return {std::move(mesh), std::move(metric), std::move(surface)};
}

} // namespace

Canonical_form::Canonical_form(std::shared_ptr<const Input> surface)
    : parts_(parts_of(triangulation_of(std::move(surface)))) {}

Canonical_form::Canonical_form(const Corresponding_triangulation& t)
    : parts_(parts_of(t.correspondence().has_inserted_vertices()
                          ? triangulation_of(t.shared_input())
                          : Corresponding_triangulation(t))) {}

bool Canonical_form::is_unique() const { return parts_->is_proven() && parts_->choice().empty(); }
std::string Canonical_form::note() const { return parts_->choice(); }
const Input& Canonical_form::input() const { return parts_->delaunay().input(); }
std::uint32_t Canonical_form::number_of_flat_vertices() const {
  return parts_->number_of_flat_vertices();
}
std::uint32_t Canonical_form::number_of_darts() const { return parts_->darts().size(); }
std::uint32_t Canonical_form::next(std::uint32_t d) const { return parts_->darts().next[d]; }
std::uint32_t Canonical_form::opposite(std::uint32_t d) const {
  return parts_->darts().opposite[d];
}
std::uint32_t Canonical_form::source(std::uint32_t d) const { return parts_->source(d); }
double Canonical_form::squared_length(std::uint32_t d) const {
  return internal::rounded_squared_length(*parts_, d);
}
std::uint64_t Canonical_form::hash() const { return internal::hash_of_surface(*parts_); }

} // namespace CGAL::Intrinsic_triangulations
