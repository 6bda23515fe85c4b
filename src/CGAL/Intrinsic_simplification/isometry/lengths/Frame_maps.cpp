// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_simplification/isometry/lengths/Frame_maps.h>
#include <CGAL/Intrinsic_simplification/isometry/lengths/Plane_charts.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

void Frame_maps::set_inverses(Map a, Map b) {
  nodes_[a - 1 - number_at_start_].inverse = b;
  nodes_[b - 1 - number_at_start_].inverse = a;
}

Frame_maps::Map Frame_maps::motion(const Plane_motion& m) {
  if (Plane_charts::is_identity(m)) return identity;
  if (const auto known = known_motions_.find(m); known != known_motions_.end())
    return known->second;
  const auto add_motion = [this](const Plane_motion& x) {
    motions_.push_back(x);
    const Map map = add({static_cast<std::uint32_t>(motions_.size()) - 1, identity, {}});
    known_motions_.emplace(x, map);
    return map;
  };
  const Plane_motion back = charts_->inverse(m);
  const Map map = add_motion(m);
  set_inverses(map, m < back || back < m ? add_motion(back) : map);
  return map;
}

Frame_maps::Map Frame_maps::composed(Map a, Map b) {
  if (a == identity) return b;
  if (b == identity) return a;
  if (inverse(a) == b) return identity;
  const std::uint64_t key = (std::uint64_t{a} << 32U) | b;
  if (const auto known = known_.find(key); known != known_.end()) return known->second;
  std::vector<Map> letters;
  append(letters, a);
  append(letters, b);
  const Map map = word(letters);
  known_.emplace(key, map);
  return map;
}

void Frame_maps::append(std::vector<Map>& word, Map m) {
  if (number_of_letters(m) > 1) {
    for (const Map letter : std::vector<Map>(letters(m))) append(word, letter);
    return;
  }
  if (m == identity) return;
  if (word.empty()) return word.push_back(m);
  const Plane_motion *x = motion_or_null(word.back()), *y = motion_or_null(m);
  if (x != nullptr && y != nullptr) {
    const Map both = motion(charts_->composed(*x, *y));
    word.pop_back();
    append(word, both);
  } else if (inverse(word.back()) == m) {
    word.pop_back();
  } else {
    word.push_back(m);
  }
}

Frame_maps::Map Frame_maps::word(const std::vector<Map>& letters) {
  if (letters.empty()) return identity;
  if (letters.size() == 1) return letters.front();
  if (const auto known = known_words_.find(letters); known != known_words_.end())
    return known->second;
  std::vector<Map> back;
  for (std::size_t i = letters.size(); i-- > 0;) back.push_back(inverse(letters[i]));
  const auto add_word = [this](const std::vector<Map>& w) {
    const Map map = add({none, identity, w});
    known_words_.emplace(w, map);
    return map;
  };
  const Map map = add_word(letters);
  set_inverses(map, back == letters ? map : add_word(back));
  return map;
}

} // namespace CGAL::Intrinsic_triangulations::internal
