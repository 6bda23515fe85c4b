// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_simplification/simplification/removal_costs.h>

#include <CGAL/Intrinsic_triangulations/support/cmath.h>

#include <algorithm>
#include <cstddef>
#include <numbers>
#include <utility>

namespace CGAL::Intrinsic_triangulations {

Transported_mass& Transported_mass::add(const std::vector<double>& values, double weight) {
  for (const double sign : {1., -1.}) {
    std::vector<Mass> channel;
    channel.reserve(values.size());
    for (const double x : values) channel.push_back({std::max(0., sign * weight * x), 0});
    if (std::ranges::any_of(channel, [](const Mass& m) { return m.amount > 0; }))
      channels_.push_back(std::move(channel));
  }
  return *this;
}

Transported_mass::Mass Transported_mass::sum(const Mass& here, const Mass& comes,
                                             const Removal_neighbor& to) {
  return {here.amount + to.share * comes.amount,
          here.moment + to.share * (to.turn * comes.moment + comes.amount * to.back)};
}

double Transported_mass::operator()(const Removal_candidate& c,
                                    std::span<const Removal_neighbor> neighbors) const {
  double result = 0;
  for (const std::vector<Mass>& channel : channels_)
    if (const Mass& comes = channel[c.number]; comes.amount > 0)
      for (const Removal_neighbor& to : neighbors)
        result += std::abs(sum(channel[to.number], comes, to).moment);
  return result;
}

void Transported_mass::remove(const Removal_candidate& c,
                              std::span<const Removal_neighbor> neighbors) {
  for (std::vector<Mass>& channel : channels_) {
    const Mass gone = channel[c.number];
    if (!(gone.amount > 0)) continue;
    for (const Removal_neighbor& to : neighbors)
      channel[to.number] = sum(channel[to.number], gone, to);
  }
}

double Balanced_cost::operator()(const Removal_candidate& c) const {
  const double weight = std::abs(c.curvature) / std::numbers::pi + (area_ > 0 ? c.area / area_ : 0);
  return weight * c.squared_length * std::exp(c.stretch / 3 + std::max(0., -c.curvature) / 4);
}

} // namespace CGAL::Intrinsic_triangulations
