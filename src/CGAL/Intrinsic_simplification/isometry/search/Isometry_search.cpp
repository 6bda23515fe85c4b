// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_simplification/isometry/Isometry_run.h>
#include <CGAL/Intrinsic_simplification/isometry/Square_root_field.h>
#include <CGAL/Intrinsic_simplification/isometry/find_isometries.h>
#include <CGAL/Intrinsic_simplification/isometry/search/Isometry_search.h>
#include <CGAL/Intrinsic_simplification/isometry/search/Length_classes.h>
#include <CGAL/Intrinsic_simplification/isometry/search/compare_sizes.h>
#include <CGAL/Intrinsic_simplification/isometry/tessellation/Repartition.h>
#include <CGAL/Intrinsic_simplification/isometry/tessellation/Singular_surface.h>
#include <CGAL/Intrinsic_triangulations/connectivity/Gluing_map.h>
#include <CGAL/Intrinsic_triangulations/formulas/Plane_vector.h>
#include <CGAL/Intrinsic_triangulations/support/cmath.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

namespace {

// Relative errors of rounded inputs, in the order in which they are tried: of
// doubles, and of coordinates in single precision.
constexpr std::array<double, 2> rounding_errors = {1e-9, 1e-5};

// How many isometries of fans of faces are tried, to find those that keep them together.
constexpr double most_maps = 1000;

constexpr const char* too_wide = "lengths are enclosed too widely to be compared";

std::string both(const std::string& x, const std::string& y) {
  return x.empty() || x == y ? y : y.empty() ? x : x + "; " + y;
}

bool has_changed_lengths(const Singular_surface& s) {
  return s.surface().report().mollification.delta > 0;
}

std::uint32_t sheets_of(const Singular_surface& s) { return s.surface().names().sheets; }

} // namespace

Isometry_search::Isometry_search(Surface a, Surface b, Isometry_run& run)
    : a_(std::move(a)), b_(std::move(b)) {
  if (sheets_of(*a_) != sheets_of(*b_)) { // isometric covers say nothing about the meshes
    note_ = "one surface is a cover of its mesh, with another number of sheets than the other one";
    return;
  }
  try {
    search(run);
  } catch (const Undecidable& e) {
    note_ = both(note_, e.what());
    matching_.reset();
  }
  if (sheets_of(*a_) > 1) note_ = both(note_, "compared are the covers of the meshes");
  if (has_changed_lengths(*a_) || has_changed_lengths(*b_))
    note_ = both(note_, "mollification has changed the lengths of a surface before");
}

void Isometry_search::search(Isometry_run& run) {
  run.begin(Isometry_stage::lengths);
  if (have_sizes_far_apart(*a_, *b_)) {
    answer_ = Isometry_answer::not_isometric;
    return;
  }
  decide_exactly(run);
  if (answer_ == Isometry_answer::undecided && a_ != b_ && !a_->is_ended() && !b_->is_ended() &&
      have_different_sizes(*a_, *b_)) {
    answer_ = Isometry_answer::not_isometric;
    note_.clear(); // it said why nothing was decided
  }
  if (answer_ != Isometry_answer::not_isometric) return;
  for (const double error : rounding_errors)
    if (decide_within(error, run)) return;
  const auto has_flat = [](const Surface& s) { return s->number_of_flat_vertices() > 0; };
  if (has_flat(a_) || has_flat(b_)) { // vertices that rounding has bent are flat in one of them
    take_all_vertices(run);
    for (const double error : rounding_errors)
      if (decide_within(error, run)) return;
  }
}

void Isometry_search::take_all_vertices(Isometry_run& run) {
  for (Surface* s : {&a_, &b_}) *s = (*s)->with_all_vertices(run);
}

void Isometry_search::match(const Length_classes& classes) {
  const bool is_one = a_ == b_;
  matching_.emplace(first_->darts, classes.of_dart.front(), is_one ? nullptr : &second_->darts,
                    is_one ? nullptr : &classes.of_dart.back());
  number_of_walks_ += matching_->number_of_walks();
  maps_.clear();
  are_all_found_ = true;
}

void Isometry_search::decide_exactly(Isometry_run& run) {
  const auto exact = [](const Singular_surface& s) { return Tessellation{s.ties(), s.darts()}; };
  first_ = exact(*a_);
  std::vector<const Singular_surface*> surfaces{a_.get()};
  if (a_ != b_) {
    second_ = exact(*b_);
    surfaces.push_back(b_.get());
  }
  note_ = both(a_->open(), b_->open());
  if (!a_->is_proven() || !b_->is_proven()) return;
  const Length_classes classes = exact_length_classes(surfaces);
  run.begin(Isometry_stage::maps);
  match(classes);
  if (matching_->is_given_up()) {
    note_ = both(note_, "too many darts look alike");
  } else if (matching_->are_isomorphic()) {
    const bool is_map = find_maps();
    if (!classes.are_proven) note_ = both(note_, "lengths could not be proven to be equal");
    if (!is_map && !are_all_found_)
      note_ = both(note_, "fans of faces that meet at a vertex are matched apart");
    if (classes.are_proven && is_map) answer_ = Isometry_answer::isometric;
    if (classes.are_proven && !is_map && are_all_found_) answer_ = Isometry_answer::not_isometric;
  } else if (!classes.are_separated) {
    note_ = both(note_, too_wide);
  } else if (!classes.are_proven) {
    note_ = both(note_, "lengths could not be proven to be equal");
  } else {
    answer_ = Isometry_answer::not_isometric;
  }
  note_ = both(both(a_->continuous_part(), b_->continuous_part()), note_);
  if (answer_ == Isometry_answer::isometric)
    largest_difference_ = 0;
  else
    matching_.reset();
}

bool Isometry_search::decide_within(double error, Isometry_run& run) {
  run.begin(Isometry_stage::maps);
  const auto rounded = [error](const Singular_surface& s) {
    std::vector<char> ties = s.ties_within(error);
    Dart_complex darts(s.triangulation().mesh(), ties);
    return Tessellation{std::move(ties), std::move(darts)};
  };
  first_ = rounded(*a_);
  second_ = rounded(*b_);
  const Singular_surface* const surfaces[] = {a_.get(), b_.get()};
  const Dart_complex* const complexes[] = {&first_->darts, &second_->darts};
  match(rounded_length_classes(surfaces, error, complexes));
  if (!matching_->is_given_up() && matching_->are_isomorphic() && find_maps()) {
    // a class may be a long chain of lengths, each near to the next one
    const double difference = difference_of(own(0));
    if (difference <= 2 * error) {
      largest_difference_ = difference;
      answer_ = Isometry_answer::isometric_within;
      return true;
    }
  }
  matching_.reset();
  return false;
}

bool Isometry_search::find_maps() {
  if (!first_->darts.has_pinched_vertex()) return true;
  const double all = number_of_maps_of_fans();
  are_all_found_ = all <= most_maps;
  const auto number = static_cast<std::size_t>(std::min(all, most_maps));
  std::vector<std::size_t> found;
  for (std::size_t n = 0; n < number && (are_all_found_ || found.empty()); ++n) {
    expect_to_go_on();
    if (respects_vertices(own(n))) found.push_back(n);
  }
  maps_ = std::move(found);
  return !maps_.empty();
}

Isometry Isometry_search::own(std::size_t n) const {
  return isometry(std::shared_ptr<const Isometry_search>(std::shared_ptr<void>(), this), n);
}

bool Isometry_search::respects_vertices(const Isometry& map) const {
  const Dart_complex& to = a_ == b_ ? first_->darts : second_->darts;
  std::vector<std::uint32_t> from(b_->surface().number_of_vertices(), Dart_complex::none);
  for (std::uint32_t d = 0; d < first_->darts.size(); ++d) {
    if (a_->is_on_cylinder(Gluing_map::Halfedge{first_->darts.halfedge[d]})) continue;
    const std::uint32_t e = map.image_of_dart(d), v = a_->source(first_->darts.halfedge[d]),
                        w = b_->source(to.halfedge[map.is_mirrored(d) ? to.next[e] : e]);
    if (map.image_of_vertex(v) != w || (from[w] != Dart_complex::none && from[w] != v))
      return false;
    from[w] = v;
  }
  return true;
}

double Isometry_search::difference_of(const Isometry& map) const {
  double largest = 0;
  const double factor = std::ldexp(1.0, exponent_to_units_of(*b_, *a_));
  for (std::uint32_t d = 0; d < first_->darts.size(); ++d) {
    const auto measure = [](const Singular_surface& s, std::uint32_t halfedge) {
      return s.triangulation().approximate(s.measure(halfedge / 2));
    };
    const std::uint32_t h = first_->darts.halfedge[d];
    const double x = measure(*a_, h),
                 y = measure(*b_, second_->darts.halfedge[map.image_of_dart(d)]) * factor;
    // a height is an area divided by a length of the border: its error adds up from both
    const double errors = a_->crosses_cylinder(h / 2) ? 3 : 1;
    largest = std::max(largest, errors * std::abs(std::sqrt(y / x) - 1));
  }
  return largest + 0x1p-50; // more than rounding here
}

double Isometry_search::count() const {
  if (!matching_) return 0;
  if (are_all_found_ && !maps_.empty()) return static_cast<double>(maps_.size());
  return number_of_maps_of_fans();
}

double Isometry_search::number_of_maps_of_fans() const {
  double count = 1;
  for (const Dart_matching::Group& g : matching_->groups())
    for (std::size_t k = 1; k <= g.firsts.size(); ++k)
      count *= static_cast<double>(k) * static_cast<double>(g.symmetries.size());
  return count;
}

Directed_dart Isometry_search::composed(const Dart_matching::Group& g, const Directed_dart& first,
                                        const Directed_dart& second, const Directed_dart& symmetry,
                                        std::vector<std::uint32_t>& image) const {
  std::vector<std::uint32_t> visited;
  matching_->walk(g.first_dart, second, image, visited);
  const std::uint32_t to = image[symmetry.dart];
  for (const std::uint32_t d : visited) image[d] = Dart_complex::none;
  return {to, (first.is_mirrored != symmetry.is_mirrored) != second.is_mirrored};
}

void Isometry_search::compute(std::size_t n, Isometry& result) const {
  if (!maps_.empty() && are_all_found_)
    n = maps_[n];
  else if (!maps_.empty() && (n == 0 || n == maps_[0]))
    n = maps_[0] - n; // they change places
  const std::uint32_t shift = a_ == b_ ? 0 : first_->darts.size();
  std::vector<std::uint32_t> image(matching_->number_of_darts(), Dart_complex::none),
      scratch = image, visited;
  result.is_mirrored_.assign(first_->darts.size(), 0);
  const auto digit = [&n](std::size_t base) {
    const std::size_t d = n % base;
    n /= base;
    return d;
  };
  for (const Dart_matching::Group& g : matching_->groups()) {
    std::vector<Directed_dart> targets = g.seconds;
    for (const Directed_dart& first : g.firsts) {
      const std::size_t symmetry = digit(g.symmetries.size()), target = digit(targets.size());
      const Directed_dart to = composed(g, first, targets[target], g.symmetries[symmetry], scratch);
      targets.erase(targets.begin() + static_cast<std::ptrdiff_t>(target));
      visited.clear();
      matching_->walk(first.dart, to, image, visited);
      for (const std::uint32_t d : visited) result.is_mirrored_[d] = to.is_mirrored ? 1 : 0;
    }
  }
  const Dart_complex& to = a_ == b_ ? first_->darts : second_->darts;
  result.vertices_.assign(a_->surface().number_of_vertices(), Canonical_form::none);
  for (std::uint32_t d = 0; d < first_->darts.size(); ++d) {
    const std::uint32_t e = image[d] - shift;
    result.image_.push_back(e);
    if (a_->is_on_cylinder(Gluing_map::Halfedge{first_->darts.halfedge[d]})) continue;
    result.vertices_[a_->source(first_->darts.halfedge[d])] =
        b_->source(to.halfedge[result.is_mirrored(d) ? to.next[e] : e]);
  }
}

// The faces of a polygon in the plane, where the first side of the first one is
// on an axis. From a side on the border of a flat cylinder: faces that cover the rectangle over it.
// By symmetry, the two angles opposite an edge across the cylinder are equal; since faces are
// Delaunay, they are at most right angles. So the first face lies over its side, and copies of the
// other one complete the rectangle on both sides of it.
std::vector<Plane_face> Isometry_search::polygon(const Singular_surface& s, const Tessellation& t,
                                                 std::uint32_t halfedge) const {
  std::vector<Plane_face> all{s.triangulation().lay_out(Gluing_map::Halfedge{halfedge})};
  for (std::size_t i = 0; i < all.size(); ++i) {
    const Plane_face f = all[i];
    for (std::size_t k = i == 0 ? 0 : 1; k < 3; ++k) {
      if (s.crosses_cylinder(f.sides[k] / 2) ? i > 0 : t.ties[f.sides[k] / 2] == 0) continue;
      Plane_face g =
          s.triangulation().lay_out(Gluing_map::opposite(Gluing_map::Halfedge{f.sides[k]}));
      const Plane_vector<double> from = f.corners[(k + 1) % 3], to = f.corners[k];
      const double length = g.corners[1].x;
      for (Plane_vector<double>& p : g.corners) p = from + (to - from) * p / length;
      all.push_back(g);
    }
  }
  return all;
}

Surface_point Isometry_search::image(const Isometry& map, const Surface_point& p) const {
  const Gluing_map::Halfedge h{p.halfedge};
  const bool is_on_cylinder = a_->is_on_cylinder(h);
  const std::vector<Plane_face> own_faces =
      polygon(*a_, *first_, is_on_cylinder ? a_->border_of_cylinder(p.halfedge) : p.halfedge);
  const auto own = std::find_if(own_faces.begin(), own_faces.end(), [&](const Plane_face& f) {
    return f.face == a_->triangulation().mesh().face(h).index;
  });
  for (const Plane_face& f : own_faces) {
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t dart = first_->darts.dart[f.sides[k]];
      if (dart == Dart_complex::none) continue;
      // where the point is relative to the dart
      const Plane_vector<double> side = f.corners[(k + 1) % 3] - f.corners[k];
      Plane_vector<double> z = in_frame(side, own->place(p) - f.corners[k]) / dot(side, side);
      if (map.is_mirrored(dart)) z.x = 1 - z.x;
      if (is_on_cylinder) z.x -= std::floor(z.x);
      const Tessellation& second = a_ == b_ ? *first_ : *second_;
      const std::vector<Plane_face> faces =
          polygon(*b_, second, second.darts.halfedge[map.image_of_dart(dart)]);
      return point_at(faces, faces.front().corners[1].x * z);
    }
  }
  return p; // every polygon has a side
}

std::vector<Surface_point> Isometry_search::images(const Isometry& map,
                                                   std::span<const Surface_point> points) const {
  std::vector<Surface_point> result = a_->from_surface(points);
  for (Surface_point& p : result) p = image(map, p);
  return b_->to_surface(result);
}

} // namespace CGAL::Intrinsic_triangulations::internal
