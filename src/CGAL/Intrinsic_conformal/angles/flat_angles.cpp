// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_conformal/angles/Angle_system.h>
#include <CGAL/Intrinsic_conformal/angles/flat_angles.h>
#include <CGAL/Intrinsic_triangulations/support/Invalid_input.h>
#include <CGAL/Intrinsic_triangulations/support/cmath.h>

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <numbers>
#include <string>

namespace CGAL::Intrinsic_triangulations::internal {

namespace {

// A quarter turn is the unit of curvature here.
constexpr double quarter_turn = std::numbers::pi / 2;

// Places cones one after another, in all components at once.
class Cone_placer {
public:
  Cone_placer(Ideal_surface& surface, std::size_t number, Prescribed_angles& angles);
  void place();

  // Whether no cone is needed; the least number of cones that all components can have; the most.
  bool needs_none() const;
  long least_number() const;
  long most_number() const;
  // The largest difference of u in a component that cones which are placed lead to.
  double range_of_scale();

private:
  struct Component {
    std::size_t first = 0; // a vertex
    long vertices = 0;     // that are not free
    long rest = 0;         // of the curvature, for the cones to come; rounded up
    long surplus = 0;      // of `rest`, in shares of a sheet; the last cone leaves it out
    bool has_free = false; // then there is no sum to keep
    double area = 0;       // of vertices that are no cones
  };
  // the vertices of a component that are no cones with the least and the largest u
  struct Extremes {
    std::array<std::size_t, 2> row{0, 0};
    std::array<double, 2> u{std::numeric_limits<double>::infinity(),
                            -std::numeric_limits<double>::infinity()};
  };

  void find_areas(const std::vector<Ideal_face>& faces);
  static long least_number(const Component& c);
  static bool is_flat(const Component& c) { return c.rest == 0 && c.surplus == 0; }
  std::string curvature(const Component& c) const;
  void expect_possible(const Component& c) const;
  std::vector<Extremes> find_extremes();
  Eigen::VectorXd missing_curvature() const;
  long next_curvature(const Component& c, const Extremes& e, long cones) const;
  void add_cone(Component& c, std::size_t row, long curvature, bool is_last);

  Ideal_surface& surface_;
  long number_;
  Prescribed_angles& angles_;
  Ideal_components components_;
  std::vector<Component> component_;
  std::vector<double> area_;    // of each row
  std::vector<char> is_chosen_; // or free, or isolated
  std::optional<Angle_system> system_;
};

Cone_placer::Cone_placer(Ideal_surface& surface, std::size_t number, Prescribed_angles& angles)
    : surface_(surface), number_(static_cast<long>(number)), angles_(angles) {
  surface_.scale(std::vector<Double_double>(surface_.number_of_rows(), 1.));
  std::vector<Ideal_face> faces;
  surface_.read(faces);
  components_ = components_of(faces, surface_.number_of_rows());
  component_.resize(components_.faces.size());
  is_chosen_.resize(angles_.size(), 1);
  const long sheets = surface_.sheets();
  for (std::size_t c = 0; c < component_.size(); ++c) { // sheets of a cloud share faces
    const long halves = 2 * static_cast<long>(components_.faces[c]);
    component_[c].rest = -(halves / sheets);
    component_[c].surplus = halves % sheets;
  }
  for (std::size_t r = angles_.size(); r-- > 0;)
    if (const std::uint32_t i = components_.of_row[r]; i != Gluing::none) {
      component_[i].first = r;
      component_[i].rest += 4;
      is_chosen_[r] = angles_.is_free(r) ? 1 : 0;
      if (angles_.is_free(r))
        component_[i].has_free = true;
      else
        ++component_[i].vertices;
    }
  find_areas(faces);
  system_.emplace(components_, is_chosen_);
  system_->read(faces);
}

void Cone_placer::find_areas(const std::vector<Ideal_face>& faces) {
  area_.resize(angles_.size(), 0);
  for (const Ideal_face& f : faces)
    for (const int r : f.rows) area_[static_cast<std::size_t>(r)] += f.area();
  for (std::size_t r = 0; r < area_.size(); ++r)
    if (is_chosen_[r] == 0) component_[components_.of_row[r]].area += area_[r];
}

// Of those with other angles; none at all is possible besides if there is no curvature.
long Cone_placer::least_number(const Component& c) {
  if (c.has_free) return 0;
  return c.rest > 0 ? (c.rest + 2) / 3 : c.rest < 0 || c.surplus > 0 ? 1 : 2;
}

bool Cone_placer::needs_none() const {
  return std::ranges::all_of(component_,
                             [](const Component& c) { return c.has_free || is_flat(c); });
}

long Cone_placer::least_number() const {
  long least = 0;
  for (const Component& c : component_) least = std::max(least, least_number(c));
  return least;
}

long Cone_placer::most_number() const {
  long most = std::numeric_limits<long>::max();
  for (const Component& c : component_) most = std::min(most, c.vertices);
  return most;
}

double Cone_placer::range_of_scale() {
  const Eigen::VectorXd u = system_->solve(missing_curvature());
  std::vector<std::array<double, 2>> range(
      component_.size(),
      {std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()});
  for (std::size_t r = 0; r < angles_.size(); ++r)
    if (const std::uint32_t c = components_.of_row[r]; c != Gluing::none) {
      const double value = u[static_cast<Eigen::Index>(r)];
      range[c] = {std::min(range[c][0], value), std::max(range[c][1], value)};
    }
  double largest = 0;
  for (const auto& [least, most] : range) largest = std::max(largest, most - least);
  return largest;
}

// In words.
std::string Cone_placer::curvature(const Component& c) const {
  if (c.surplus == 0) return std::to_string(c.rest) + " pi/2";
  const long sheets = surface_.sheets();
  return std::to_string(c.rest * sheets - c.surplus) + "/" + std::to_string(sheets) + " pi/2";
}

void Cone_placer::expect_possible(const Component& c) const {
  const std::string of = "the component of vertex " + std::to_string(c.first);
  if (c.vertices < number_)
    throw Invalid_input(Element_kind::vertex, c.first,
                        of + " has only " + std::to_string(c.vertices) + " vertices for " +
                            std::to_string(number_) + " cones; place fewer");
  const long least = least_number(c);
  if (number_ >= least || (is_flat(c) && number_ == 0)) return;
  throw Invalid_input(Element_kind::vertex, c.first,
                      of + " cannot be flat with " + std::to_string(number_) +
                          " cones, whose curvature sums to " + curvature(c) + "; place at least " +
                          std::to_string(least) + (is_flat(c) ? ", or none" : ""));
}

Eigen::VectorXd Cone_placer::missing_curvature() const {
  const double sheets = surface_.sheets();
  Eigen::VectorXd result = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(angles_.size()));
  for (std::size_t r = 0; r < angles_.size(); ++r) {
    if (components_.of_row[r] == Gluing::none || angles_.is_free(r)) continue;
    const auto i = static_cast<Eigen::Index>(r);
    const Component& c = component_[components_.of_row[r]];
    result[i] = system_->angle_sums()[i] - sheets * angles_.radians(r);
    if (is_chosen_[r] == 0 && !c.has_free && c.area > 0)
      result[i] += quarter_turn *
                   (sheets * static_cast<double>(c.rest) - static_cast<double>(c.surplus)) *
                   (area_[r] / c.area);
  }
  return result;
}

// The curvature of the next of so many cones.
long Cone_placer::next_curvature(const Component& c, const Extremes& e, long cones) const {
  const long wanted = e.u[1] > -e.u[0] ? -1 : 1;
  if (c.has_free) return wanted;
  if (cones == 1) return c.rest;
  const long size = std::abs(c.rest);
  if (size >= cones) return (c.rest > 0 ? 1 : -1) * ((size + cones - 1) / cones);
  // one cone cannot make up for nothing
  return cones == 2 && c.surplus == 0 && c.rest == wanted ? -wanted : wanted;
}

void Cone_placer::add_cone(Component& c, std::size_t row, long curvature, bool is_last) {
  const long sheets = surface_.sheets();
  angles_.set(row, is_last && c.surplus > 0 && !c.has_free
                       ? Multiple_of_pi{(4 - curvature) * sheets + c.surplus, 2 * sheets}
                       : Multiple_of_pi{4 - curvature, 2});
  is_chosen_[row] = 1;
  c.rest -= curvature;
  c.area -= area_[row];
}

std::vector<Cone_placer::Extremes> Cone_placer::find_extremes() {
  const Eigen::VectorXd u = system_->solve(missing_curvature());
  std::vector<Extremes> extremes(component_.size());
  for (std::size_t r = 0; r < angles_.size(); ++r) {
    if (is_chosen_[r] != 0) continue;
    Extremes& e = extremes[components_.of_row[r]];
    const double value = u[static_cast<Eigen::Index>(r)];
    if (value < e.u[0]) {
      e.u[0] = value;
      e.row[0] = r;
    }
    if (value > e.u[1]) {
      e.u[1] = value;
      e.row[1] = r;
    }
  }
  return extremes;
}

void Cone_placer::place() {
  for (const Component& c : component_) expect_possible(c);
  for (long cones = number_; cones > 0; --cones) {
    const std::vector<Extremes> extremes = find_extremes();
    for (std::size_t i = 0; i < component_.size(); ++i) {
      const long curvature = next_curvature(component_[i], extremes[i], cones);
      add_cone(component_[i], extremes[i].row[curvature > 0 ? 0 : 1], curvature, cones == 1);
    }
  }
}

} // namespace

Prescribed_angles flat_angles(const Ideal_surface& surface) {
  Prescribed_angles angles(surface.number_of_rows());
  if (surface.sheets() == 1) return angles;
  std::vector<std::uint32_t> copies(angles.size(), 0);
  for (const std::uint32_t row : surface.row_of_vertex())
    if (row != Gluing::none) ++copies[row];
  for (std::size_t r = 0; r < copies.size(); ++r)
    if (copies[r] == 1) angles.set_free(r);
  return angles;
}

void place_cones(Ideal_surface& surface, std::size_t number, Prescribed_angles& angles) {
  Cone_placer(surface, number, angles).place();
}

void place_cones_within(Ideal_surface& surface, double ratio, Prescribed_angles& angles) {
  if (!(ratio > 1) || !std::isfinite(ratio))
    throw Invalid_input(Element_kind::none, 0,
                        "the ratio of scales within which cones are to keep the surface is not a "
                        "number above 1");
  const Prescribed_angles flat = angles;
  const Cone_placer first(surface, 0, angles);
  const long least = first.least_number(), most = first.most_number();
  double best = std::numeric_limits<double>::infinity();
  for (long n = first.needs_none() ? 0 : least; n <= most;
       n = std::max(least, n + std::max(1L, n / 4))) {
    angles = flat;
    Cone_placer placer(surface, static_cast<std::size_t>(n), angles);
    placer.place();
    const double range = placer.range_of_scale();
    if (range <= std::log(ratio)) return;
    best = std::min(best, range);
  }
  const std::string range = "no number of cones keeps scales within a ratio of ";
  throw Invalid_input(Element_kind::none, 0,
                      std::isfinite(std::exp(best))
                          ? range + std::to_string(ratio) + "; allow at least " +
                                std::to_string(std::exp(best))
                          : range + "doubles; vertices may nearly coincide, merge them");
}

} // namespace CGAL::Intrinsic_triangulations::internal
