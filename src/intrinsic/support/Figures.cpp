// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Figures.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <sstream>

namespace program {

namespace {

constexpr std::size_t most_shown = 12; // elements of a list: more would not be read

bool is_known(const Json& figure) {
  return !figure.is_null() && !(figure.is_number_float() && !std::isfinite(figure.get<double>()));
}

// Takes the next word off a text.
std::string_view next_word(std::string_view& text, char separator) {
  const std::size_t n = std::min(text.find(separator), text.size());
  const std::string_view word = text.substr(0, n);
  text.remove_prefix(std::min(n + 1, text.size()));
  return word;
}

// The figure at a place that begins after a slash.
Json figure_at(const Json& json, std::string_view place) {
  if (place.empty()) return is_known(json) ? json : Json();
  const std::string_view name = next_word(place, '/');
  if (json.is_array() && name == "#") return json.size();
  if (json.is_array() && name == "last")
    return json.empty() ? Json() : figure_at(json.back(), place);
  if (json.is_array() && name == "*") {
    Json all = Json::array();
    for (const Json& element : json) all.push_back(figure_at(element, place));
    return all;
  }
  const auto found = json.is_object() ? json.find(std::string(name)) : json.end();
  return found == json.end() ? Json() : figure_at(*found, place);
}

std::string shown(const Json& figure) {
  if (figure.is_string()) return figure.get<std::string>();
  if (figure.is_boolean()) return figure.get<bool>() ? "yes" : "no";
  if (figure.is_null()) return "none";
  if (!figure.is_array()) {
    if (!figure.is_number_float()) return figure.dump();
    std::ostringstream text;
    text << figure.get<double>();
    return text.str();
  }
  std::string text;
  for (std::size_t i = 0; i < figure.size() && i < most_shown; ++i)
    text += (i == 0 ? "" : ", ") + shown(figure[i]);
  if (figure.size() > most_shown) text += ", ... (" + std::to_string(figure.size()) + " in all)";
  return text;
}

// The noun of a count.
std::string noun_of(const Json& count, std::string_view nouns) {
  const std::string one(next_word(nouns, ' '));
  if (count == 1) return " " + one;
  return " " + (nouns.empty() ? one + "s" : std::string(nouns));
}

} // namespace

Json Figures::at(std::string_view place) const { return figure_at(json_, place.substr(1)); }

double Figures::number(std::string_view place) const {
  const Json figure = at(place);
  return figure.is_number() ? figure.get<double>() : std::numeric_limits<double>::quiet_NaN();
}

std::string Figures::word(std::string_view place) const {
  const Json figure = at(place);
  return figure.is_string() ? figure.get<std::string>() : std::string();
}

bool Figures::has(std::string_view place) const {
  const Json figure = at(place);
  return figure.is_number()    ? figure != 0
         : figure.is_boolean() ? figure.get<bool>()
         : figure.is_string()  ? !figure.get<std::string>().empty()
                               : !figure.empty();
}

std::optional<std::string> Figures::fill(std::string_view text) const {
  std::string filled;
  while (!text.empty()) {
    filled += next_word(text, '{');
    if (text.empty()) break;
    std::string_view inside = next_word(text, '}');
    const Json figure = at(next_word(inside, ' '));
    if (figure.is_null() || (figure.is_array() && figure.empty())) return std::nullopt;
    filled += shown(figure);
    if (!inside.empty()) filled += noun_of(figure, inside);
  }
  return filled;
}

} // namespace program
