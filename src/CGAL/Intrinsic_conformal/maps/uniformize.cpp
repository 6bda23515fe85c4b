// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_conformal/maps/uniformize.h>
#include <CGAL/Intrinsic_geodesics/cuts/cut_input.h>
#include <CGAL/Intrinsic_triangulations/connectivity/Gluing.h>
#include <CGAL/Intrinsic_triangulations/connectivity/Gluing_map.h>
#include <CGAL/Intrinsic_triangulations/connectivity/as_gluing.h>
#include <CGAL/Intrinsic_triangulations/connectivity/topology.h>
#include <CGAL/Intrinsic_triangulations/domains/Domain.h>
#include <CGAL/Intrinsic_triangulations/input/definition_of.h>
#include <CGAL/Intrinsic_triangulations/support/Invalid_input.h>
#include <CGAL/Intrinsic_triangulations/support/cmath.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

std::vector<std::uint32_t> Uniformization::cones() const {
  std::vector<std::uint32_t> result;
  for (std::uint32_t row = 0; row < angles.size(); ++row)
    if (!angles.is_free(row) && angles.radians(row) != Multiple_of_pi().radians())
      result.push_back(row);
  return result;
}

Intrinsic_input closed_double(const Input& surface) {
  return make_domain(sheet_of_cover(definition_of(surface)), Domain_kind::closed).input;
}

namespace internal {

namespace {

Invalid_input no_disks(const std::string& what) {
  return {Element_kind::none, 0,
          "a conformal map with scale 1 on the border is one of disks, but the surface " + what +
              "; uniformize it, with cones where that asks for them, or map it by another method, "
              "which cuts it open"};
}

// The triangles of the front, or of all of a surface that is no double. \return whether none of
// them is glued to the back of another one
bool find_front(const Input& surface, Gluing& front) {
  const Gluing all = gluing_from_map(surface.mesh());
  const Input_names& names = surface.names();
  std::vector<std::uint32_t> number(all.origin.size(), Gluing::none), sides;
  for (std::uint32_t user = 0; user < surface.number_of_faces(); user += names.sheets)
    for (std::uint32_t k = 0; k < 3; ++k) {
      sides.push_back(3 * names.faces.here(user) + k);
      number[sides.back()] = static_cast<std::uint32_t>(sides.size() - 1);
    }
  front.number_of_vertices = surface.number_of_rows();
  for (const std::uint32_t h : sides) {
    front.origin.push_back(names.row(all.origin[h]));
    const std::uint32_t other = Gluing::partner(all.glue[h]);
    front.glue.push_back(other == Gluing::none ? other : number[other]);
    if (other != Gluing::none && front.glue.back() == Gluing::none && // but its own back
        names.faces.user(other / 3) / 2 != names.faces.user(h / 3) / 2)
      return false;
  }
  return true;
}

bool has_angles(const Uniformize_options& o) {
  return o.cones || o.scale_ratio || static_cast<bool>(o.prescribe);
}

Uniform_target target_of(const Uniformize_options& options, const Choice_facts& facts) {
  if (has_angles(options) || facts.sheets != 1 || facts.components != 1)
    return Uniform_target::plane;
  switch (facts.euler_characteristic) {
  case 2:
    return Uniform_target::sphere;
  case 0:
    return Uniform_target::torus;
  default:
    return facts.euler_characteristic % 2 == 0 ? Uniform_target::disk : Uniform_target::plane;
  }
}

std::string unreached(const Conformal_metric& m) {
  std::ostringstream words;
  words << "the solution is not reached: angles differ from the prescribed ones by up to "
        << m.residual << " radians, too much for a layout; take other angles or cones, or the "
        << "scale factors alone";
  return words.str();
}

} // namespace

void choose(Uniformize_options& options, const Choice_facts& facts) {
  const auto refuse = [](const std::string& what) {
    throw Invalid_input(Element_kind::none, 0, what);
  };
  if (options.start == Uniform_start::automatic)
    options.start = facts.has_inserted ? Uniform_start::input : Uniform_start::delaunay;
  if (options.start == Uniform_start::delaunay && facts.has_inserted)
    refuse("scale factors belong to the vertices of the mesh, and others were inserted; start from "
           "the triangles of the mesh: \"input\"");
  if (options.target == Uniform_target::automatic) {
    options.target = target_of(options, facts);
    return;
  }
  const bool is_plane = options.target == Uniform_target::plane;
  if (has_angles(options) && !is_plane && options.target != Uniform_target::disk)
    refuse("spheres and flat tori have no cones; leave angles and cones out");
  if ((options.cones || options.scale_ratio) && !is_plane)
    refuse("cones are placed on flat surfaces; list those of a hyperbolic one with their angles");
}

void take_sphere(Uniformization& result, Conformal_sphere sphere, std::vector<double> u) {
  if (!std::ranges::all_of(u, [](double x) { return std::isfinite(x); }))
    throw Invalid_input(Element_kind::none, 0,
                        "vertices fall together on the sphere in doubles; map it to the plane, "
                        "with cones");
  result.status = sphere.status;
  result.metric = sphere.metric;
  for (const double x : u) result.scale_factors.push_back(std::exp(x / 2));
  result.u = std::move(u);
  result.sphere = std::move(sphere);
}

void try_to_lay_out(Uniformization& result, const std::function<void()>& lay_out) {
  const bool is_done = result.metric.status == Status::done;
  try {
    lay_out();
  } catch (const std::invalid_argument&) { // matrices that are not finite
    if (is_done) throw;
    result.no_layout = unreached(result.metric);
  } catch (const Invalid_input&) {
    if (is_done) throw;
    result.no_layout = unreached(result.metric);
  }
}

std::vector<char> faces_without_area(const Input& surface) {
  std::vector<char> result;
  for (std::uint32_t f = 0; f < surface.number_of_faces(); ++f) {
    double most = 0; // of the squared lengths
    for (const Gluing_map::Halfedge h : surface.mesh().sides({f}))
      most = std::max(most, surface.squared_length(h.index / 2));
    result.push_back(surface.quadruple_area(f) <= 0x1p-50 * most ? 1 : 0);
  }
  return result;
}

std::string why_no_front(const Input& surface) {
  Gluing front;
  if (!surface.names().is_cloud() && find_front(surface, front)) return {};
  return "the faces are not oriented alike, so that the surface has no front that can be laid out; "
         "orient them, or take the scale factors alone";
}

} // namespace internal

Gluing front_of(const Input& surface) {
  Gluing front;
  if (!internal::find_front(surface, front))
    throw internal::no_disks("is not an oriented manifold");
  return front;
}

void expect_disks(const Input& surface) {
  if (surface.names().is_cloud())
    throw Invalid_input(Element_kind::none, 0,
                        "for a cloud of points only the method spectral works");
  const Gluing_map front = Gluing_map::from_valid(front_of(surface));
  if (std::ranges::any_of(umbrellas(front), [](std::uint32_t n) { return n > 1; }))
    throw internal::no_disks("has parts that meet at a vertex only");
  const std::size_t components = connected_components(front).count,
                    borders = boundary_loops(front).size();
  if (genus(front).value_or(1) != 0) throw internal::no_disks("has handles");
  if (borders == 0) throw internal::no_disks("is closed");
  if (borders != components)
    throw internal::no_disks(components == 1
                                 ? "has " + std::to_string(borders) + " borders"
                                 : "has " + std::to_string(components) + " components and " +
                                       std::to_string(borders) + " borders, not one for each");
}

} // namespace CGAL::Intrinsic_triangulations
