// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_triangulations/connectivity/Gluing.h>
#include <CGAL/Intrinsic_triangulations/input/Element_names.h>

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

Element_names Element_names::after(const Element_names& renumbered) const {
  if (is_identity() || renumbered.is_identity()) return is_identity() ? renumbered : *this;
  std::vector<std::uint32_t> users;
  users.reserve(renumbered.user_.size());
  for (const std::uint32_t i : renumbered.user_) users.push_back(user(i));
  return Element_names(std::move(users));
}

std::uint32_t Input_names::vertex(std::uint32_t row) const {
  if (row_of_vertex.empty()) return vertices.here(row);
  const auto first = std::lower_bound(row_of_vertex.begin(), row_of_vertex.end(), row);
  return vertices.here(static_cast<std::uint32_t>(first - row_of_vertex.begin()));
}

std::vector<std::uint32_t> Element_names::inverse_of(const std::vector<std::uint32_t>& user) {
  std::vector<std::uint32_t> result;
  for (std::uint32_t i = 0; i < user.size(); ++i) {
    if (user[i] == Gluing::none) continue;
    if (user[i] >= result.size()) result.resize(user[i] + std::size_t{1}, Gluing::none);
    result[user[i]] = i;
  }
  return result;
}

} // namespace CGAL::Intrinsic_triangulations
