// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_SUPPORT_FIGURES_H
#define INTRINSIC_SUPPORT_FIGURES_H

#include "Json.h"

#include <optional>
#include <string>
#include <string_view>

namespace program {

/*!
\brief finds the figures of statistics by their places, and puts them into texts for people.

A place is such as `/quality/min_angle_deg`. `last` is the last element of a list, `#` is how many
it has, and `*` stands for all of them: `/cut/components/` `*` `/area` is a list of areas.
*/
class Figures {
public:
  /// \param json the statistics, which must outlive this object
  explicit Figures(const Json& json) : json_(json) {}

  /// returns the figure at a place; null if there is none, or if it is a number that is not finite.
  Json at(std::string_view place) const;
  /// returns the number at a place, or NaN if there is none.
  double number(std::string_view place) const;
  /// returns the word at a place, or an empty one if there is none.
  std::string word(std::string_view place) const;
  /// tells whether there is something at a place: no null, false, zero, or empty text or list.
  bool has(std::string_view place) const;

  /*!
  \brief puts figures into a text: at `{/a/b}` the one at this place; with a noun, as in
  `{/a/b flip}`, also the noun, in the plural where it must be. The plural may follow it.
  \return the text; none if a figure is missing
  */
  std::optional<std::string> fill(std::string_view text) const;

private:
  const Json& json_;
};

} // namespace program

#endif // INTRINSIC_SUPPORT_FIGURES_H
