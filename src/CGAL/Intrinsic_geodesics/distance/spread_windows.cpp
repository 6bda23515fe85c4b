// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_geodesics/distance/Changing_values.h>
#include <CGAL/Intrinsic_geodesics/distance/Crossed_windows.h>
#include <CGAL/Intrinsic_geodesics/distance/Distance_field.h>
#include <CGAL/Intrinsic_geodesics/distance/Window.h>
#include <CGAL/Intrinsic_geodesics/distance/Window_queue.h>
#include <CGAL/Intrinsic_geodesics/distance/spread_windows.h>
#include <CGAL/Intrinsic_triangulations/connectivity/Gluing.h>
#include <CGAL/Intrinsic_triangulations/support/Status.h>
#include <CGAL/Intrinsic_triangulations/support/cmath.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <numbers>
#include <span>
#include <utility>
#include <vector>

/*!
\file
Exact distances on a polyhedral surface: Chen and Han's tree of windows (1990), explored by distance
and pruned as Xin and Wang do (2009), with the windows of a side together, as Qin et al. do for
faces (2016).

A source sees faces through windows: intervals of sides, beyond which the faces in between are laid
out in the plane. A window that looks into a face is split by its far corner, or goes to one of the
other sides. Corners get distances from the windows that show them. Where the angles around a vertex
are more than a full turn, and more than half a turn on the border, shortest paths may pass through
it; it becomes a source of the sector that the path before cannot get to.

**What prunes.** A window is dropped if an end of its side, or the far corner of its face, is near
enough to serve all that it could: the path by way of that vertex would cross those through the
window, and is shorter. The distances of vertices are those of paths, final or not, so that this is
right at all times. Only the nearest of the windows of a side that show the far corner goes on to
both sides (Chen and Han's "one angle, one split"). These arguments stay within one face and the
layout of the faces before it: they hold on any Delta-complex, also where a shortest path crosses a
face more than once.

**Where more than two faces meet** a window goes on into each of the others. The rules about the
corners of one face hold as they are: the paths that they compare meet at points of that face. "One
angle, one split" holds among windows only that came through the same faces of such edges, see
`Crossed_windows`. Vertices there end fans, and paths go on from fan to fan everywhere.

**The order.** The queue gives vertices by their distance, and sides by the least distance of a
point of the windows that wait there, which parts of windows never undercut. So the distance of a
vertex is final when the vertex comes. The other windows of the side come earlier than they would
alone. That is right, and pays: the queue has a twentieth of the elements, and windows share what
depends on the side.

**It ends.** Windows are useless that are farther than all vertices and an edge; nearer ones are
finitely many, as a straight line turns by less than half a turn around each vertex that it passes,
and the next is some way off. On a body k times as long as thick, windows wind around it up to about
k times before they are longer than those that do not. From k = 10^7 on rounding hides which are
longer: a cap on the number of windows stands in for the proof.

**Rounding.** Comparisons are tolerant in the direction that keeps windows. A window drawn to a
corner shows it if the corner lies off its rays by rounding; so no corner is lost between two
windows, at an error of second order. Distances are lengths of segments, never results of
comparisons. A vertex that is so near to an image that rounding hides directions behind it looks
there itself; a source within rounding of a vertex leaves it to the vertex altogether.
*/

namespace CGAL::Intrinsic_triangulations::internal {

void Places::add(std::uint32_t v, std::uint32_t index) { vertices.push_back({v, index}); }
void Places::add(const Point_in_face& p, std::uint32_t index) { points.push_back({p, index}); }

struct Propagation_memory::Arrays {
  explicit Arrays(const Distance_field& field)
      : queue(field.table.corners.size()), split(field.table.corners.size()),
        is_final(field.vertices.size()) {}

  Window_queue queue;
  Changing_values<Split> split; // per side
  Crossed_windows crossed;
  Changing_values<char> is_final; // per vertex
};

Propagation_memory::Propagation_memory() = default;
Propagation_memory::~Propagation_memory() = default;
Propagation_memory::Propagation_memory(Propagation_memory&&) noexcept = default;
Propagation_memory& Propagation_memory::operator=(Propagation_memory&&) noexcept = default;

Propagation_memory::Arrays& Propagation_memory::cleared(const Distance_field& field) {
  if (!arrays_) arrays_ = std::make_unique<Arrays>(field);
  arrays_->queue.clear();
  arrays_->split.reset();
  arrays_->crossed.clear();
  arrays_->is_final.reset();
  return *arrays_;
}

std::size_t Propagation_memory::bytes() const {
  return arrays_ ? arrays_->queue.bytes() + arrays_->split.bytes() + arrays_->is_final.bytes() : 0;
}

namespace {

// Spreads windows from the sources of a field over the surface.
class Window_propagation {
public:
  // Sources are added before `run()`, vertices first.
  Window_propagation(Distance_field& field, Propagation_memory::Arrays& memory);
  void add_source(const Places::Numbered<std::uint32_t>& v);
  void add_source(const Places::Numbered<Point_in_face>& source);
  void open_source(std::uint32_t source);
  Status run(const Propagation_limits& limits,
             const std::function<bool(std::uint64_t, double)>& progress);
  std::uint64_t number_of_windows() const { return count_; }

private:
  // A face around a vertex, and what of its angle is meant.
  struct Wedge {
    std::uint32_t corner;
    double angle;
  };
  // A window by its place in the queue, and the far corner of its face.
  struct View {
    std::uint32_t window;
    Squared_rays rays;
    Apex_view apex;
  };
  // Distances of the corners of a face.
  struct Corner_distances {
    double at_source, at_target, at_apex;
  };

  void reach(std::uint32_t v, double distance, const Arrival& arrival);
  void finish(std::uint32_t v);
  void reach_copies(std::uint32_t v);
  void open_fan(std::uint32_t v, std::uint32_t first, bool everywhere);
  void open_closed_fan(std::uint32_t v, std::size_t arrival, double angle, double hidden);
  void open_border_fan(std::uint32_t v, std::size_t arrival, double angle, double hidden);
  void open_wedge(std::uint32_t v, const Wedge& wedge, double from, double to);
  double find_arrival(std::uint32_t v, std::size_t& index) const;
  double rounding_around(std::uint32_t corner) const;
  double hidden_angle(std::uint32_t v, std::uint32_t corner) const;
  void add_window(std::uint32_t side, Window w);
  void add_window(std::uint32_t side, Window& w, double at_source, double at_target, double length);
  void add_behind(const Branched_side& branch, Window& w, double at_source, double at_target,
                  double length);
  void add_first_window(std::uint32_t back, Window w);
  void part_at_sources(std::uint32_t side, Window& w);
  void look_through(std::uint32_t side);
  void collect_views(std::uint32_t side, const Window_face& face);
  void look_through(std::uint32_t side, const Window_face& face, std::span<const View> views);
  std::uint32_t crossing_of(const View& view);
  const View* show_apex(std::uint32_t side, const Window_face& face, std::span<const View> views,
                        Split& split);
  void pass_on(const View& view, const Window_face& face, const Corner_distances& distances,
               double nearest_crossing, bool is_nearest);
  bool knows_targets(const Propagation_limits& limits) const;

  Distance_field& field_;
  const Corner_table& table_;
  Window_queue& queue_;
  Changing_values<Split>& split_;
  Changing_values<char>& is_final_;
  Crossed_windows& crossed_;
  std::vector<Wedge> fan_;  // of the vertex that is dealt with
  std::vector<View> views_; // of the side that is dealt with
  double radius_ = std::numeric_limits<double>::infinity();
  std::uint64_t count_ = 0;
  std::uint64_t most_windows_ = std::numeric_limits<std::uint64_t>::max();
};

Window_propagation::Window_propagation(Distance_field& field, Propagation_memory::Arrays& memory)
    : field_(field), table_(field.table), queue_(memory.queue), split_(memory.split),
      is_final_(memory.is_final), crossed_(memory.crossed) {}

void Window_propagation::add_source(const Places::Numbered<std::uint32_t>& v) {
  reach(v.place, 0, {{0, 0}, Gluing::none, v.place, Arrival::Kind::at_source, v.index});
}

void Window_propagation::add_source(const Places::Numbered<Point_in_face>& source) {
  const std::uint32_t face = source.place.side / 3;
  field_.sources_by_face.insert(std::upper_bound(field_.sources_by_face.begin(),
                                                 field_.sources_by_face.end(), face,
                                                 [this](std::uint32_t f, std::uint32_t s) {
                                                   return f < field_.face_sources[s].side / 3;
                                                 }),
                                static_cast<std::uint32_t>(field_.face_sources.size()));
  field_.face_sources.push_back(source.place);
  field_.origins.push_back(source.index);
}

// Looks from a source in a face, by its number, to all sides. Within rounding of a corner it only
// reaches the corners: the vertex there looks around for it.
void Window_propagation::open_source(std::uint32_t source) {
  const Point_in_face p = field_.face_sources[source - field_.vertices.size()];
  const std::uint32_t face = p.side / 3;
  bool is_at_corner = false;
  for (std::uint32_t c = 3 * face; c < 3 * face + 3; ++c)
    is_at_corner = is_at_corner || planar_distance(field_.turned_to(c, p.point, p.side), {0, 0}) <=
                                       rounding_around(c);
  for (std::uint32_t side = 3 * face; side < 3 * face + 3; ++side) {
    const Plane_vector<double> q = field_.turned_to(side, p.point, p.side);
    const Face_corner& c = table_.corners[side];
    const Window_face f(table_, side);
    reach(f.left.origin, planar_distance(q, f.apex), {q, side, source, Arrival::Kind::straight});
    if (is_at_corner || c.opposite == Gluing::none) continue;
    add_first_window(side, {0, c.length, {c.length - q.x, -q.y}, 0, source, Gluing::none});
  }
}

// Takes note of a path to a vertex.
void Window_propagation::reach(std::uint32_t v, double distance, const Arrival& arrival) {
  Distance_and_arrival& known = field_.vertices[v];
  if (!(distance < known.distance) || is_final_[v] != 0) return; // the latter by rounding
  known = {distance, arrival};
  if (arrival.kind != Arrival::Kind::at_source)
    known.arrival.origin = field_.origin(arrival.source);
  if (distance <= radius_) queue_.push_vertex(distance, v);
}

// A vertex has its distance. Paths go on along edges: others are shorter unless the vertex is a
// source, but these bound them early, and reach what windows miss by more than they are tolerant.
void Window_propagation::finish(std::uint32_t v) {
  is_final_.set(v, 1);
  const bool is_source = field_.vertices[v].arrival.kind == Arrival::Kind::at_source;
  if (table_.first_corner[v] == Gluing::none) return;
  if (!table_.next_copy.empty()) reach_copies(v);
  open_fan(v, table_.first_corner[v], is_source);
  auto other = std::lower_bound(table_.other_fans.begin(), table_.other_fans.end(),
                                std::pair(v, std::uint32_t{0}));
  for (; other != table_.other_fans.end() && other->first == v; ++other)
    open_fan(v, other->second, is_source);
}

// On a cover, paths go on from any copy of a vertex. Where that gains no more than rounding makes,
// they stay on their side.
void Window_propagation::reach_copies(std::uint32_t v) {
  constexpr double least = 1 - 1e-12; // rounding of 9000 sums, one for each vertex on a path
  const double distance = field_.vertices[v].distance;
  for (std::uint32_t w = table_.next_copy[v]; w != v; w = table_.next_copy[w])
    if (distance < field_.vertices[w].distance * least)
      reach(w, distance, {{0, 0}, Gluing::none, v, Arrival::Kind::copied});
}

// The index in the fan of the face where the shortest path comes from, and the angle from the side
// of its corner to the path. If the path comes from another fan, the index is the size of the fan.
double Window_propagation::find_arrival(std::uint32_t v, std::size_t& index) const {
  const Arrival& a = field_.vertices[v].arrival;
  if (a.kind != Arrival::Kind::straight) return 0;
  const auto found = std::find_if(fan_.begin(), fan_.end(),
                                  [&](const Wedge& w) { return w.corner == a.corner(); });
  index = static_cast<std::size_t>(found - fan_.begin());
  if (found == fan_.end()) return 0;
  const Window_face f(table_, a.side);
  const double x = a.image.x - f.apex.x, y = a.image.y - f.apex.y;
  const double angle = std::atan2(-f.apex.x * y + f.apex.y * x, -f.apex.x * x - f.apex.y * y);
  return std::clamp(angle, 0.0, found->angle);
}

// Windows that pass a vertex on its two sides have images that rounding has moved apart: by units
// in the last place of the sides around, which this sums up for the fan of a corner.
double Window_propagation::rounding_around(std::uint32_t corner) const {
  double longest = 0, faces = 0;
  const auto add = [&](std::uint32_t c) {
    longest = std::max(
        {longest, table_.corners[c].length, table_.corners[Corner_table::previous(c)].length});
    ++faces;
  };
  std::uint32_t c = corner;
  do add(c);
  while ((c = table_.turn_left(c)) != Gluing::none && c != corner);
  if (c == Gluing::none)
    while ((corner = table_.turn_right(corner)) != Gluing::none) add(corner);
  return 0x1p-51 * faces * longest;
}

// The nearer an image is to a vertex, the more directions behind it neither of these windows shows.
// Returns the angle, 0 if the tolerance of windows makes up for it.
double Window_propagation::hidden_angle(std::uint32_t v, std::uint32_t corner) const {
  const Arrival& a = field_.vertices[v].arrival;
  const double rounding = rounding_around(corner);
  const double distance = planar_distance(a.image, Window_face(table_, a.side).apex);
  return rounding > window_angle_tolerance * distance ? rounding / distance : 0;
}

// Looks from a vertex into the faces of a fan, as far as shortest paths may go on there.
void Window_propagation::open_fan(std::uint32_t v, std::uint32_t first, bool everywhere) {
  fan_.clear();
  std::uint32_t c = first;
  const double distance = field_.vertices[v].distance;
  do {
    const Face_corner& corner = table_.corners[c];
    const Face_corner& back = table_.corners[Corner_table::previous(c)];
    fan_.push_back({c, std::atan2(corner.sine, corner.cosine)});
    everywhere = everywhere || !(corner.length > 0 && back.length > 0);
    reach(table_.corners[Corner_table::next(c)].origin, distance + corner.length,
          {{back.length, 0}, Corner_table::previous(c), v, Arrival::Kind::straight});
    reach(back.origin, distance + back.length, {{0, 0}, c, v, Arrival::Kind::straight});
    c = table_.turn_left(c);
  } while (c != Gluing::none && c != first);
  std::size_t index = fan_.size();
  const double angle = everywhere ? 0 : find_arrival(v, index);
  const double hidden = index == fan_.size() ? 0 : hidden_angle(v, first);
  if (index == fan_.size() || !(hidden < 0.5))
    for (const Wedge& w : fan_) open_wedge(v, w, 0, w.angle);
  else if (c == Gluing::none)
    open_border_fan(v, index, angle, hidden);
  else
    open_closed_fan(v, index, angle, hidden);
}

// Paths go on where they leave half a turn at least on both sides.
void Window_propagation::open_closed_fan(std::uint32_t v, std::size_t arrival, double angle,
                                         double hidden) {
  double total = 0;
  for (const Wedge& w : fan_) total += w.angle;
  if (total + 2 * hidden <= 2 * std::numbers::pi + window_angle_tolerance / 4) return;
  const double from = std::numbers::pi - window_angle_tolerance - hidden;
  const double to = total - from;
  double turned = -angle;
  for (std::size_t i = 0; i < fan_.size(); ++i) {
    const Wedge& w = fan_[(arrival + i) % fan_.size()];
    open_wedge(v, w, from - turned, to - turned);
    turned += w.angle;
  }
}

void Window_propagation::open_border_fan(std::uint32_t v, std::size_t arrival, double angle,
                                         double hidden) {
  const double half = std::numbers::pi + window_angle_tolerance / 4 - hidden;
  const double from = std::numbers::pi - window_angle_tolerance - hidden;
  double left = -angle, right = angle;
  for (std::size_t i = arrival; i < fan_.size(); ++i) left += fan_[i].angle;
  for (std::size_t i = 0; i < arrival; ++i) right += fan_[i].angle;
  if (left > half) {
    double turned = -angle;
    for (std::size_t i = arrival; i < fan_.size(); ++i) {
      open_wedge(v, fan_[i], from - turned, fan_[i].angle);
      turned += fan_[i].angle;
    }
  }
  if (right > half) {
    double turned = angle - fan_[arrival].angle; // to the right
    for (std::size_t i = arrival + 1; i-- > 0;) {
      open_wedge(v, fan_[i], 0, fan_[i].angle - (from - turned));
      turned += fan_[i].angle;
    }
  }
}

// Looks from a vertex across a face, between two angles from the side of its corner.
void Window_propagation::open_wedge(std::uint32_t v, const Wedge& wedge, double from, double to) {
  if (!(from < wedge.angle) || !(to > 0)) return;
  const std::uint32_t side = Corner_table::next(wedge.corner);
  const Window_face f(table_, side); // v is its apex
  if (f.base.opposite == Gluing::none) return;
  const auto place = [&](double angle) { // on the side, of the ray at an angle
    const double s = std::sin(angle);
    return std::clamp(f.left.length * s / (f.base.cosine * s + f.base.sine * std::cos(angle)), 0.0,
                      f.base.length);
  };
  const double length = f.base.length;
  add_first_window(side, {to >= wedge.angle ? 0 : length - place(to),
                          from <= 0 ? length : length - place(from),
                          {length - f.apex.x, -f.apex.y},
                          field_.vertices[v].distance,
                          v,
                          Gluing::none});
}

void Window_propagation::add_window(std::uint32_t side, Window w) {
  const Face_corner& c = table_.corners[side];
  const std::uint32_t target = table_.corners[Corner_table::next(side)].origin;
  if (is_window(w))
    add_window(side, w, field_.vertices[c.origin].distance, field_.vertices[target].distance,
               c.length);
}

// Where several faces go on, a window goes on into each of them.
void Window_propagation::add_behind(const Branched_side& branch, Window& w, double at_source,
                                    double at_target, double length) {
  for (const Branched_side::Other& other : branch.others) {
    Window behind = w;
    if (branch.others.size() > 1)
      behind.source = crossed_.crossing(field_, w.source, branch.side, other.side);
    if (other.is_along) { // seen from its own ends
      behind.begin = length - w.end;
      behind.end = length - w.begin;
      behind.image.x = length - w.image.x;
      add_window(other.side, behind, at_target, at_source, length);
    } else {
      add_window(other.side, behind, at_source, at_target, length);
    }
  }
}

// The ends of the side, which has a length, have distances. It may be the number of a branch.
void Window_propagation::add_window(std::uint32_t side, Window& w, double at_source,
                                    double at_target, double length) {
  if (side >= Face_corner::first_branch) [[unlikely]]
    return add_behind(table_.branches[side - Face_corner::first_branch], w, at_source, at_target,
                      length);
  const Squared_rays rays(w);
  if (rays.are_useless(w, at_source, at_target, length)) return;
  const double squared = rays.least(w), radius = radius_ - w.offset;
  if (radius >= 0 && squared <= radius * radius) queue_.push_window(squared, side, w);
}

// Parts a window by the ray through a point, if that crosses it. Returns whether there is a right
// part.
bool part_at(Window& w, Plane_vector<double> p, Window& right) {
  const double cut = w.image.x - (p.x - w.image.x) * (w.image.y / (p.y - w.image.y));
  if (!(p.y > w.image.y && cut > w.begin && cut < w.end)) return false;
  right = w;
  right.begin = w.end = cut;
  return true;
}

// Adds a window whose source is in the face before the edge of a side of it, `back`. Other sources
// in that face part it: paths that pass behind one do not cross those of the nearest window, which
// would cut them off.
void Window_propagation::add_first_window(std::uint32_t back, Window w) {
  const Face_corner& c = table_.corners[back];
  Window right;
  for (const std::uint32_t s : field_.sources_in_face(back / 3)) {
    const Point_in_face& source = field_.face_sources[s];
    const Plane_vector<double> p = field_.turned_to(back, source.point, source.side);
    if (part_at(w, {c.length - p.x, -p.y}, right)) add_first_window(back, right);
  }
  if (is_window(w))
    add_window(c.opposite, w,
               field_.vertices[table_.corners[Corner_table::next(back)].origin].distance,
               field_.vertices[c.origin].distance, c.length);
}

// Parts a window by the ray through a source in its face, as a vertex there would do: parts show no
// source, as they show no vertex.
void Window_propagation::part_at_sources(std::uint32_t side, Window& w) {
  for (const std::uint32_t s : field_.sources_in_face(side / 3)) {
    const Point_in_face& source = field_.face_sources[s];
    Window right;
    if (part_at(w, field_.turned_to(side, source.point, source.side), right))
      add_window(side, right);
  }
}

// Looks into a face through the windows of a side.
void Window_propagation::look_through(std::uint32_t side) {
  const Window_face face(table_, side);
  collect_views(side, face);
  if (table_.branches.empty()) return look_through(side, face, views_);
  std::ranges::stable_sort(views_, {}, [this](const View& v) { return crossing_of(v); });
  for (auto begin = views_.begin(); begin != views_.end();) {
    const auto end = std::ranges::find_if_not(
        begin, views_.end(), [&](const View& v) { return crossing_of(v) == crossing_of(*begin); });
    look_through(side, face, {begin, end});
    begin = end;
  }
}

// The last crossing of a window; all that have none are alike.
std::uint32_t Window_propagation::crossing_of(const View& view) {
  const std::uint32_t source = queue_.window(view.window).source;
  return Crossing::is_one(source) ? source : 0;
}

// Looks into a face through windows of a side that have crossed the same branches.
void Window_propagation::look_through(std::uint32_t side, const Window_face& face,
                                      std::span<const View> views) {
  if (views.empty()) return;
  const std::uint32_t crossed = table_.branches.empty() ? 0 : crossing_of(views.front());
  Split split = crossed == 0 ? split_[side] : crossed_.split(side, crossed);
  const View* nearest = show_apex(side, face, views, split);
  if (nearest != nullptr && crossed == 0) split_.set(side, split);
  if (nearest != nullptr && crossed != 0) crossed_.split(side, crossed) = split;
  const Corner_distances distances{field_.vertices[face.base.origin].distance,
                                   field_.vertices[face.right.origin].distance,
                                   field_.vertices[face.left.origin].distance};
  for (const View& view : views) pass_on(view, face, distances, split.crossing, &view == nearest);
}

void Window_propagation::collect_views(std::uint32_t side, const Window_face& face) {
  const double at_source = field_.vertices[face.base.origin].distance;
  const double at_target = field_.vertices[face.right.origin].distance;
  views_.clear();
  for (std::uint32_t i = queue_.take_windows(side), next = i; i != Gluing::none; i = next) {
    next = queue_.window(i).next;
    if (!field_.face_sources.empty()) {
      Window part = queue_.window(i);
      part_at_sources(side, part);
      queue_.window(i).end = part.end;
    }
    const Window& w = queue_.window(i);
    const Squared_rays rays(w);
    if (rays.are_useless(w, at_source, at_target, face.base.length)) {
      queue_.free(i);
      continue;
    }
    if (Crossing::is_one(w.source) && crossed_.is_covered(field_, side, w, face.base.length)) {
      queue_.free(i);
      continue;
    }
    ++count_;
    if (field_.windows.are_kept()) field_.windows.add(w, side, face.base.length);
    views_.push_back({i, rays, Apex_view(w, rays, face)});
  }
}

// Finds the nearest window that shows the far corner, and takes note of it; null if an earlier one
// of the side is as near.
const Window_propagation::View* Window_propagation::show_apex(std::uint32_t side,
                                                              const Window_face& face,
                                                              std::span<const View> views,
                                                              Split& nearest) {
  const View* result = nullptr;
  for (const View& view : views) {
    if (!view.apex.is_seen()) continue;
    const double distance =
        queue_.window(view.window).offset + std::sqrt(view.apex.squared_distance);
    if (!(distance < nearest.distance)) continue;
    nearest = {distance, view.apex.crossing};
    result = &view;
  }
  if (result != nullptr) {
    const Window& w = queue_.window(result->window);
    reach(face.left.origin, nearest.distance, {w.image, side, w.source, Arrival::Kind::straight});
  }
  return result;
}

// Passes a window on to the other sides of its face. If it shows the far corner it goes to the side
// where it does not cross the paths of the nearest. Where its line to the corner is that of the
// nearest, neither crosses paths of the other: it goes on to the sides that have more of it than
// rounding makes.
void Window_propagation::pass_on(const View& view, const Window_face& face,
                                 const Corner_distances& distances, double nearest_crossing,
                                 bool is_nearest) {
  const auto& [i, rays, apex] = view;
  const Window w = queue_.window(i);
  queue_.free(i);
  bool left = apex.is_not_before, right = apex.is_not_after;
  if (apex.is_seen() && !is_nearest) {
    if (!apex.is_near(nearest_crossing)) {
      left = apex.crossing < nearest_crossing;
      right = !left;
    } else {
      left = !apex.is_near_begin(w, rays);
      right = !apex.is_near_end(w, rays);
    }
  }
  const double more = distances.at_apex - w.offset;
  // the line from the apex to an end of the window crosses all paths to the side on the other hand
  const auto is_useless = [&](double end, double square) {
    constexpr double least = 1 - window_distance_tolerance;
    const Plane_vector<double> down = face.apex - Plane_vector<double>{end, 0};
    const double by_apex = dot(down, down);
    if (more >= 0 && by_apex >= square) return false; // as nearly always
    return more + std::sqrt(by_apex) < std::sqrt(square) * least;
  };
  Window child;
  if (left && !is_useless(w.begin, rays.begin) && left_child(w, face, apex.is_not_after, child))
    add_window(face.left.opposite, child, distances.at_source, distances.at_apex, face.left.length);
  if (right && !is_useless(w.end, rays.end) && right_child(w, face, apex.is_not_before, child))
    add_window(face.right.opposite, child, distances.at_apex, distances.at_target,
               face.right.length);
}

bool Window_propagation::knows_targets(const Propagation_limits& limits) const {
  const auto& [vertices, points] = limits.targets;
  if (vertices.empty() && points.empty()) return false;
  const double least = queue_.least();
  return std::all_of(vertices.begin(), vertices.end(),
                     [&](const auto& v) { return field_.vertices[v.place].distance <= least; }) &&
         std::all_of(points.begin(), points.end(),
                     [&](const auto& p) { return field_.at(p.place).distance <= least; });
}

Status Window_propagation::run(const Propagation_limits& limits,
                               const std::function<bool(std::uint64_t, double)>& progress) {
  constexpr std::uint64_t most_between_progress = 65536; // windows; matters to cancelled runs alone
  radius_ = limits.radius;
  field_.radius = limits.radius;
  most_windows_ =
      std::min<std::uint64_t>(limits.windows, std::numeric_limits<std::uint32_t>::max() - 1);
  std::uint64_t next_progress = most_between_progress;
  std::uint32_t element = 0;
  for (std::uint64_t step = 1; !queue_.is_empty(); ++step) {
    const bool is_known = step % 64 == 0 && knows_targets(limits);
    const bool is_cap = count_ >= most_windows_;
    bool is_cancelled = false;
    if (count_ >= next_progress) {
      next_progress = count_ + most_between_progress;
      is_cancelled = !progress(count_, queue_.least());
    }
    if (is_known || is_cap || is_cancelled) {
      field_.radius = std::min(limits.radius, queue_.least());
      return is_known ? Status::done : is_cap ? Status::cap : Status::cancelled;
    }
    if (!queue_.pop(element))
      look_through(element);
    else if (is_final_[element] == 0)
      finish(element);
  }
  return Status::done;
}

} // namespace

std::pair<Status, std::uint64_t>
spread_windows(Distance_field& field, const Places& sources, const Propagation_limits& limits,
               Propagation_memory& memory,
               const std::function<bool(std::uint64_t, double)>& progress) {
  Window_propagation propagation(field, memory.cleared(field));
  for (const auto& v : sources.vertices) propagation.add_source(v);
  auto next = static_cast<std::uint32_t>(field.vertices.size() + field.face_sources.size());
  for (const auto& p : sources.points) propagation.add_source(p);
  for (; next < field.vertices.size() + field.face_sources.size(); ++next)
    propagation.open_source(next);
  const Status status = propagation.run(limits, progress);
  return {status, propagation.number_of_windows()};
}

} // namespace CGAL::Intrinsic_triangulations::internal
