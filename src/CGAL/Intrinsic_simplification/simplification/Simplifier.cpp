// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_simplification/simplification/Simplifier.h>
#include <CGAL/Intrinsic_triangulations/support/cmath.h>

#include <algorithm>
#include <limits>
#include <utility>

namespace CGAL::Intrinsic_triangulations::internal {

namespace {

// Proofs add less than this to the spread of flat faces. Where users allow no stretch, this much is
// allowed, so that flat vertices go. If the spread is greater than expected by no more than this,
// no other vertex is tried first.
constexpr double negligible_spread = 1e-9;

} // namespace

Simplifier::Simplifier(const Fine_surface& fine, const std::vector<char>& may_go,
                       const Simplify_options& options, Asked_cost& cost)
    : fine_(fine), options_(options), mesh_(fine), vertices_(fine.gluing.number_of_vertices),
      candidates_(fine, cost) {
  if (candidates_.need_vectors()) mesh_.track_turns();
  find_copies();
  mark_kept(may_go);
  keep_copies();
  count_components();
  for (std::uint32_t v = 0; v < vertices_.size(); ++v) {
    if (mesh_.outgoing(v) == Gluing::none) continue;
    ++number_left_;
    if (v == first_copy(v)) push(v);
  }
}

bool Simplifier::is_last(std::uint32_t v) const {
  const Vertex& of = vertices_[v];
  return weight_[of.component] - weight(of) < least_weight_[of.component] ||
         (of.is_on_border && left_on_loop_[of.loop] == 1);
}

// Notes that a vertex is gone, or is there again.
void Simplifier::add_to_counts(std::uint32_t v, int sign) {
  const Vertex& of = vertices_[v];
  weight_[of.component] += sign * weight(of);
  if (of.is_on_border) left_on_loop_[of.loop] += static_cast<std::size_t>(sign);
}

// Finds what it costs to remove a vertex, the most expensive one of its copies, and whether that is
// allowed; the star of the last one is in `neighbour_`.
bool Simplifier::find_cost(std::uint32_t v, double& cost) {
  cost = -std::numeric_limits<double>::infinity();
  for (const std::uint32_t copy : copies(v)) {
    neighbour_.find(mesh_, copy);
    const double other = candidates_.cost(mesh_, neighbour_, copy);
    if (!(other <= cost)) cost = other;
  }
  const bool is_allowed = std::isfinite(cost) && cost <= options_.cost;
  for (const std::uint32_t copy : copies(v))
    vertices_[copy].fate = is_allowed ? Fate::open : Fate::bound;
  vertices_[v].is_cost_old = false;
  return is_allowed;
}

void Simplifier::push(std::uint32_t v) {
  if (vertices_[v].fate == Fate::stays || vertices_[v].fate == Fate::removed) return;
  if (double cost = 0; find_cost(v, cost)) queue_.push({cost, v, mesh_.number(v)});
}

// Takes the cheapest vertex out of the queue, or none; its star is in `star_` if it has no copies.
Removal_entry Simplifier::pop() {
  while (!queue_.empty()) {
    Removal_entry e = queue_.top();
    const bool is_old = vertices_[e.vertex].is_cost_old;
    if (!is_old)
      star_.find(mesh_, e.vertex);
    else if (!find_cost(e.vertex, e.cost)) {
      queue_.pop();
      continue;
    } else if (!queue_.change_top(e.cost))
      continue;
    else
      std::swap(star_, neighbour_);
    queue_.pop();
    return e;
  }
  return {0, Gluing::none, Gluing::none};
}

// Whether an edge from the vertex to itself must stay, such as the last one of a border.
bool Simplifier::has_fixed_loop(std::uint32_t v) const {
  return !star_.is_proper() && std::ranges::any_of(star_.sides(), [&](std::uint32_t h) {
    return mesh_.origin(Coarse_mesh::next(h)) == v && !mesh_.is_flippable(h);
  });
}

// Flips an edge of the star so that the degree of the vertex falls, by 2 or 1.
bool Simplifier::lower_degree(std::uint32_t v) {
  const auto count = [&](std::uint32_t h) { return mesh_.origin(h) == v ? 1 : 0; };
  const auto fall = [&](std::uint32_t h) {
    const std::uint32_t g = mesh_.glued(h);
    return count(h) + count(g) - count(Coarse_mesh::previous(h)) - count(Coarse_mesh::previous(g));
  };
  for (const int most : {2, 1})
    for (const std::uint32_t h : star_.sides())
      if (mesh_.is_flippable(h) && fall(h) == most && mesh_.flip(h)) return true;
  return false;
}

// The same after another flip, which makes faces convex together.
bool Simplifier::lower_degree_in_two(std::uint32_t v) {
  const std::size_t tries = star_.size();
  for (std::size_t k = 0; k < tries && k < star_.size(); ++k) {
    const std::uint32_t h = star_.side(k);
    if (!mesh_.is_flippable(h) || !mesh_.flip(h)) continue;
    star_.find(mesh_, v);
    if (lower_degree(v)) return true;
    if (!mesh_.flip(h)) return false;
    star_.find(mesh_, v); // sides have moved
  }
  return false;
}

// Flips edges until none is from a flat vertex to itself: the degree falls, so that this ends.
bool Simplifier::open_loops(std::uint32_t v) {
  while (!star_.is_proper() && star_.find(mesh_, v) && !star_.is_proper()) {
    const std::size_t degree = star_.size();
    if (!lower_degree(v) && !lower_degree_in_two(v)) return false;
    ++step_.flips;
    if (!star_.find(mesh_, v) || star_.size() >= degree) return false;
  }
  return true;
}

void Simplifier::restore_delaunay() {
  removal_.list_edges(stack_);
  if (step_.flips > 0) // loops were flipped away
    for (const std::uint32_t f : mesh_.changed())
      if (!mesh_.face(f).is_removed)
        for (std::uint32_t h = 3 * f; h < 3 * f + 3; ++h) stack_.push_back(h);
  const std::size_t most = 100 * stack_.size() + 1000; // rounding could flip for ever
  for (std::size_t flips = 0; !stack_.empty() && flips < most;) {
    const std::uint32_t h = stack_.back();
    stack_.pop_back();
    if (!mesh_.violates_delaunay(h)) continue;
    const std::uint32_t g = mesh_.glued(h);
    if (!mesh_.flip(h)) continue;
    ++flips;
    ++step_.flips;
    for (const std::uint32_t s : {h, g})
      for (const std::uint32_t q : {Coarse_mesh::next(s), Coarse_mesh::previous(s)})
        stack_.push_back(q);
  }
}

// Finds the spread of the faces that have changed.
bool Simplifier::is_within_bounds() {
  mesh_.list_changed(touched_);
  const double stretch = std::max(options_.stretch, 1 + negligible_spread);
  const double most = stretch * stretch * (1 - negligible_spread); // proofs widen it a little
  for (const std::uint32_t f : touched_) {
    const Coarse_face& face = mesh_.face(f);
    if (face.is_removed) continue;
    if (std::isfinite(options_.stretch) &&
        !(factors(face.length, mesh_.forms(f).below)[1] <= most &&
          factors(face.length, mesh_.forms(f).above)[0] * most >= 1))
      return false;
    const double spread = spread_of(face.length, mesh_.forms(f));
    mesh_.set_spread(f, spread);
    step_.spread = std::max(step_.spread, spread);
  }
  return true;
}

// Removes a flat vertex.
Simplifier::Fate Simplifier::replace_star(std::uint32_t v) {
  coming_.advance(mesh_);
  if (!open_loops(v)) return Fate::failed;
  const double before = star_.spread();
  if (!removal_.remove(mesh_, star_, v)) return Fate::failed;
  coming_.advance(mesh_);
  restore_delaunay();
  if (!is_within_bounds()) return Fate::bound;
  if (!std::isfinite(step_.spread) && std::isfinite(before)) return Fate::failed; // no proof
  return candidates_.are_stretches() && step_.spread > options_.cost ? Fate::bound : Fate::removed;
}

// Makes the copies of a vertex flat and removes them.
Simplifier::Fate Simplifier::remove_copies(std::uint32_t v) {
  const std::span<const std::uint32_t> all = copies(v);
  Fate fate = Fate::removed;
  std::size_t gone = 0;
  for (; gone < all.size() && fate == Fate::removed; ++gone) {
    const std::uint32_t copy = all[gone];
    if (all.size() > 1) star_.find(mesh_, copy);
    fate = is_last(copy) ? Fate::stays : has_fixed_loop(copy) ? Fate::blocked : flatten(copy);
    if (fate == Fate::open) fate = replace_star(copy);
    add_to_counts(copy, -1);
  }
  for (; fate != Fate::removed && gone > 0; --gone) add_to_counts(all[gone - 1], 1);
  return fate;
}

// Removes a vertex with its copies; if it has none, its star is known.
// \return `open`: it would stretch the surface much more than expected, and others less
Simplifier::Fate Simplifier::remove(std::uint32_t v, double expected) {
  mesh_.begin();
  coming_.begin(mesh_, queue_, star_);
  step_ = {};
  if (candidates_.remember())
    candidates_.describe_all(mesh_, copies(v), [&](std::uint32_t copy) -> Vertex_star& {
      if (copies(v).size() > 1) star_.find(mesh_, copy);
      return star_;
    });
  Fate fate = remove_copies(v);
  if (fate == Fate::removed && candidates_.are_stretches() &&
      step_.spread > 1.25 * expected + negligible_spread && !queue_.empty() &&
      step_.spread > queue_.top().cost) {
    for (const std::uint32_t copy : copies(v)) add_to_counts(copy, 1);
    fate = Fate::open;
  }
  counts_.newton_steps += step_.newton_steps;
  if (fate != Fate::removed) {
    mesh_.take_back();
    return fate;
  }
  if (candidates_.remember()) candidates_.remove(mesh_);
  counts_.ptolemy_flips += step_.ptolemy_flips;
  counts_.flips += step_.flips;
  return fate;
}

// Costs of vertices in the queue are found again when it is their turn, which saves most of them;
// those that stayed get a new chance.
void Simplifier::renew_costs() {
  for (const std::uint32_t f : touched_) {
    if (mesh_.face(f).is_removed) continue;
    for (const std::uint32_t corner : mesh_.face(f).origin)
      if (const std::uint32_t v = first_copy(corner); vertices_[v].fate == Fate::open)
        vertices_[v].is_cost_old = true;
      else
        push(v);
  }
}

void Simplifier::run(std::size_t wanted) {
  status_ = number_left_ <= wanted ? Status::done : Status::stalled;
  while (number_left_ > wanted) {
    const auto [expected, v, number] = pop();
    if (v == Gluing::none) return;
    if (++number_tried_ % 256 == 0 && options_.progress &&
        !options_.progress({number_removed_, number_left_})) {
      status_ = Status::cancelled;
      return;
    }
    const Fate fate = remove(v, expected);
    for (const std::uint32_t copy : copies(v)) vertices_[copy].fate = fate;
    if (fate == Fate::open) queue_.push({step_.spread, v, number});
    if (fate != Fate::removed) continue;
    number_left_ -= copies(v).size();
    number_removed_ += copies(v).size();
    if (number_left_ <= wanted) status_ = Status::done;
    renew_costs();
  }
}

} // namespace CGAL::Intrinsic_triangulations::internal
