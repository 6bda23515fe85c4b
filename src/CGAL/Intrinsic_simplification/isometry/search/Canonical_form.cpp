// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_simplification/isometry/Canonical_form.h>
#include <CGAL/Intrinsic_simplification/isometry/Isometry_run.h>
#include <CGAL/Intrinsic_simplification/isometry/search/hash_of_surface.h>
#include <CGAL/Intrinsic_simplification/isometry/tessellation/Singular_surface.h>
#include <CGAL/Intrinsic_triangulations/input/Input.h>
#include <CGAL/Intrinsic_triangulations/support/Status.h>
#include <CGAL/Intrinsic_triangulations/support/cmath.h>

#include <cstdint>
#include <memory>
#include <string>
#include <utility>

namespace CGAL::Intrinsic_triangulations {

namespace {

std::shared_ptr<const internal::Singular_surface> parts_of(Corresponding_triangulation t,
                                                           const Isometry_options& options) {
  internal::Isometry_run run(options);
  return std::make_shared<const internal::Singular_surface>(
      std::move(t), internal::Tessellation_vertices::not_flat, run);
}

} // namespace

const char* name_of(Isometry_stage stage) {
  switch (stage) {
  case Isometry_stage::flips:
    return "flipping to Delaunay";
  case Isometry_stage::flat_vertices:
    return "removing flat vertices";
  case Isometry_stage::ties:
    return "finding cocircular faces";
  case Isometry_stage::lengths:
    return "comparing lengths";
  case Isometry_stage::maps:
    break;
  }
  return "searching for isometries";
}

Canonical_form::Canonical_form(std::shared_ptr<const Input> surface,
                               const Isometry_options& options)
    : parts_(parts_of(internal::triangulation_of(std::move(surface)), options)) {}

Canonical_form::Canonical_form(const Corresponding_triangulation& t,
                               const Isometry_options& options)
    : parts_(parts_of(t.correspondence().has_inserted_vertices()
                          ? internal::triangulation_of(t.shared_input())
                          : Corresponding_triangulation(t),
                      options)) {}

Status Canonical_form::status() const {
  return parts_->is_ended() ? Status::cancelled : Status::done;
}

bool Canonical_form::is_unique() const { return note().empty(); }
std::string Canonical_form::note() const {
  if (!parts_->is_proven() || !parts_->has_cylinder()) return parts_->open();
  return "the vertices on the borders of a flat cylinder are arbitrary";
}
const Input& Canonical_form::input() const { return parts_->surface(); }
std::uint32_t Canonical_form::number_of_flat_vertices() const {
  return parts_->number_of_flat_vertices();
}
std::uint32_t Canonical_form::number_of_darts() const { return parts_->darts().size(); }
std::uint32_t Canonical_form::next(std::uint32_t d) const { return parts_->darts().next[d]; }
std::uint32_t Canonical_form::opposite(std::uint32_t d) const {
  return parts_->darts().opposite[d];
}
std::uint32_t Canonical_form::source(std::uint32_t d) const {
  return parts_->source(parts_->darts().halfedge[d]);
}
double Canonical_form::squared_length(std::uint32_t d) const {
  return internal::rounded_squared_length(*parts_, d);
}
std::uint64_t Canonical_form::hash(const Isometry_options& options) const {
  internal::Isometry_run run(options);
  return internal::hash_of_surface(*parts_, run);
}

} // namespace CGAL::Intrinsic_triangulations
