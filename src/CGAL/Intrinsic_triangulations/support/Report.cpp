// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_triangulations/support/Report.h>

#include <initializer_list>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <variant>

namespace CGAL::Intrinsic_triangulations {

Report::Report() = default;
Report::Report(const Report& other) = default;
Report::Report(Report&& other) noexcept = default;
Report& Report::operator=(const Report& other) = default;
Report& Report::operator=(Report&& other) noexcept = default;
Report::~Report() = default;
Report::Report(const char* x) : value_(std::string(x)) {}
Report::Report(std::string x) : value_(std::move(x)) {}
Report::Report(List x) : value_(std::move(x)) {}
Report::Report(Figures x) : value_(std::move(x)) {}
Report::Report(std::initializer_list<Figure> figures) : value_(Figures(figures)) {}
Report::List::const_iterator Report::begin() const { return get<List>().begin(); }
Report::List::const_iterator Report::end() const { return get<List>().end(); }

const Report& Report::at(std::string_view name) const {
  if (const Report* found = find(name)) return *found;
  throw std::out_of_range("there is no figure " + std::string(name));
}

Report& Report::operator[](std::string_view name) {
  if (std::holds_alternative<std::monostate>(value_)) value_ = Figures();
  Figures& figures = std::get<Figures>(value_);
  for (Figure& f : figures)
    if (f.name == name) return f.value;
  return figures.emplace_back(Figure{std::string(name), {}}).value;
}

const Report* Report::find(std::string_view name) const {
  if (const auto* figures = std::get_if<Figures>(&value_))
    for (const Figure& f : *figures)
      if (f.name == name) return &f.value;
  return nullptr;
}

} // namespace CGAL::Intrinsic_triangulations
