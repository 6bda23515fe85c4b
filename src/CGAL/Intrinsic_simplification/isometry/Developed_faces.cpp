// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_simplification/isometry/Developed_faces.h>
#include <CGAL/Intrinsic_simplification/isometry/Value_recipes.h>
#include <CGAL/Intrinsic_triangulations/connectivity/Gluing.h>
#include <CGAL/Intrinsic_triangulations/connectivity/Gluing_map.h>
#include <CGAL/Intrinsic_triangulations/formulas/Diamond.h>

#include <CGAL/Gmpq.h>

#include <cstddef>
#include <cstdint>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

Developed_faces::Developed_faces(const Value_recipes& recipes) : recipes_(recipes) {
  const Gluing_map& mesh = recipes.triangulation().mesh();
  const std::uint32_t n = mesh.number_of_halfedges();
  first_side_.resize(mesh.number_of_faces());
  for (std::uint32_t h = 0; h < n; ++h) {
    face_.push_back(mesh.face(Halfedge{h}).index);
    next_.push_back(mesh.next(Halfedge{h}).index);
    if (face_[h] != Gluing::none) first_side_[face_[h]] = h;
  }
  frame_ = face_;
  vector_.resize(n);
  turn_.resize(n);
  std::iota(vector_.begin(), vector_.end(), Id{0});
  std::iota(turn_.begin(), turn_.end(), n);
}

void Developed_faces::bring_across(const Gluing_map& mesh, Halfedge h) {
  const Id turn = turn_[h.index];
  if (turn == one()) return;
  const Halfedge o = Gluing_map::opposite(h);
  const std::uint32_t from = frame_[o.index], to = frame_[h.index];
  const Id back = add({Kind::inverse, turn, 0, from, to});
  Halfedge x = o;
  do {
    vector_[x.index] = product(turn, vector_[x.index]);
    frame_[x.index] = to;
    const Halfedge y = Gluing_map::opposite(x);
    if (mesh.face(y).index != Gluing::none) {
      turn_[x.index] = product(turn, turn_[x.index]);
      turn_[y.index] = product(turn_[y.index], back);
    }
    x = mesh.next(x);
  } while (x != o);
  join(h);
}

void Developed_faces::join(Halfedge h) {
  turn_[h.index] = turn_[Gluing_map::opposite(h).index] = one();
}

void Developed_faces::close(Halfedge h, Halfedge first, Halfedge second, Value squared,
                            Value area) {
  const std::uint32_t frame = frame_[first.index];
  const Id v = add({Kind::closing, vector_[first.index], vector_[second.index], 0, 0});
  vector_[h.index] = v;
  frame_[h.index] = frame;
  quantities_.emplace(squared, Quantity{v, v, frame, false});
  set_area(area, first, second);
}

void Developed_faces::set_area(Value area, Halfedge first, Halfedge second) {
  quantities_.emplace(
      area, Quantity{vector_[first.index], vector_[second.index], frame_[first.index], true});
}

const Developed_faces::Evaluation::Number& Developed_faces::Evaluation::operator()(Value id) {
  const auto found = faces_->quantities_.find(id);
  if (found == faces_->quantities_.end()) return values_(id);
  if (const auto known = moved_values_.find(id); known != moved_values_.end()) return known->second;
  const Quantity& q = found->second;
  const Complex a = complex(q.a), b = complex(q.b);
  const Number& unit = values_(faces_->unit(q.frame));
  const Number product = q.is_area ? (a.first * b.second - a.second * b.first) * Number(Gmpq(2))
                                   : a.first * b.first + a.second * b.second;
  return moved_values_.emplace(id, unit * product).first->second;
}

Diamond_values<Developed_faces::Evaluation::Number>
Developed_faces::Evaluation::operator()(const Value_recipes::Diamond_ids& d) {
  const auto at = [&](std::size_t k) { return (*this)(d[k]); };
  return {at(0), at(1), at(2), at(3), at(4), at(5), at(6)};
}

const Developed_faces::Evaluation::Complex& Developed_faces::Evaluation::complex(Id id) {
  stack_.assign(1, id);
  while (!stack_.empty()) compute_next();
  return complex_.at(id);
}

// The number on top of the stack, if those that it follows from are known; else puts these there.
void Developed_faces::Evaluation::compute_next() {
  const Id id = stack_.back(), halfedges = static_cast<Id>(faces_->face_.size());
  const auto store = [&](Complex z) {
    complex_.emplace(id, std::move(z));
    stack_.pop_back();
  };
  if (complex_.count(id) != 0) return stack_.pop_back();
  if (id < halfedges) return store(vector_at_start(id));
  if (id < faces_->one()) return store(turn_at_start(id - halfedges));
  if (id == faces_->one()) return store({Number(Gmpq(1)), Number(Gmpq(0))});
  const Node& n = faces_->nodes_[id - faces_->first_node()];
  const std::size_t before = stack_.size();
  if (complex_.count(n.a) == 0) stack_.push_back(n.a);
  if (n.kind != Kind::inverse && complex_.count(n.b) == 0) stack_.push_back(n.b);
  if (stack_.size() == before) store(computed(n));
}

Developed_faces::Evaluation::Complex Developed_faces::Evaluation::computed(const Node& n) {
  const auto& [x, y] = complex_.at(n.a);
  if (n.kind == Kind::inverse) { // the squared norm is the quotient of the units
    const Number quotient = values_(faces_->unit(n.to)) / values_(faces_->unit(n.from));
    return {x * quotient, -(y * quotient)};
  }
  const auto& [u, v] = complex_.at(n.b);
  if (n.kind == Kind::closing) return {-(x + u), -(y + v)};
  return {x * u - y * v, x * v + y * u};
}

Developed_faces::Evaluation::Complex
Developed_faces::Evaluation::vector_at_start(std::uint32_t halfedge) {
  const std::uint32_t face = faces_->face_[halfedge], first = faces_->first_side_[face],
                      second = faces_->next_[first], third = faces_->next_[second];
  if (halfedge == first) return {Number(Gmpq(1)), Number(Gmpq(0))};
  const auto squared = [&](std::uint32_t h) -> Number {
    return values_(faces_->recipes_.length_of_edge(h / 2));
  };
  const Number unit = squared(first), twice = unit + unit;
  const Number x = (unit + squared(third) - squared(second)) / twice;
  const Number y = Number(values_(faces_->recipes_.area_of_face(face))) / twice;
  if (halfedge == third) return {-x, -y};
  return {x - Number(Gmpq(1)), y};
}

// Both halfedges are one vector, in opposite directions.
Developed_faces::Evaluation::Complex
Developed_faces::Evaluation::turn_at_start(std::uint32_t halfedge) {
  const std::uint32_t other = halfedge ^ 1U;
  const auto [x, y] = vector_at_start(halfedge);
  const auto [u, v] = vector_at_start(other);
  const Number norm = Number(values_(faces_->recipes_.length_of_edge(halfedge / 2))) /
                      Number(values_(faces_->unit(faces_->face_[other])));
  return {-(x * u + y * v) / norm, (x * v - y * u) / norm};
}

} // namespace CGAL::Intrinsic_triangulations::internal
