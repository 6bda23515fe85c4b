// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_SUPPORT_REPORT_H
#define CGAL_INTRINSIC_TRIANGULATIONS_SUPPORT_REPORT_H

#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

namespace internal {

template <class Value>
struct Named {
  std::string name; // unique among those beside it
  Value value;
};

} // namespace internal

/*!
\brief is a tree of figures with names, in the order in which they were set: what is reported of a
surface, and what JSON or a dictionary may be made of.

A report is nothing, a truth value, a number, a text, a list of reports, or figures with names.
*/
class Report {
public:
  using Figure = internal::Named<Report>; ///< a `name` and the report `value` that has it
  using List = std::vector<Report>;       ///< reports without names
  using Figures = std::vector<Figure>;    ///< reports with names
  /// What a report may be.
  using Value =
      std::variant<std::monostate, bool, std::int64_t, double, std::string, List, Figures>;

  /// is nothing.
  Report();
  // Defined in the source: every program that includes this header would compile how a
  // variant is copied and destroyed.

  /// copies.
  Report(const Report& other);
  /// moves.
  Report(Report&& other) noexcept;
  /// copies.
  Report& operator=(const Report& other);
  /// moves.
  Report& operator=(Report&& other) noexcept;
  /// destructs.
  ~Report();
  /// is a truth value.
  template <std::same_as<bool> Bool>
  Report(Bool x) : value_(x) {}
  /// is a whole number.
  template <std::integral Number>
    requires(!std::same_as<Number, bool>)
  Report(Number x) : value_(static_cast<std::int64_t>(x)) {}
  /// is a number.
  Report(double x) : value_(x) {}
  /// is a text.
  Report(const char* x);
  /// is a text.
  Report(std::string x);
  /// is a list.
  Report(List x);
  /// is a list of numbers.
  template <class Number, std::size_t n>
  Report(const std::array<Number, n>& x) : value_(List(x.begin(), x.end())) {}
  /// is a value, or nothing.
  template <class Known>
  Report(const std::optional<Known>& x) : Report(x ? Report(*x) : Report()) {}
  /// is figures with names.
  Report(Figures x);
  /// is figures with names.
  Report(std::initializer_list<Figure> figures);

  /// returns what it is.
  const Value& value() const { return value_; }
  /// returns what it is as a type of `Value`. \throws std::bad_variant_access if it is another one
  template <class Type>
  const Type& get() const {
    return std::get<Type>(value_);
  }
  /// returns the first report of a list. \throws std::bad_variant_access if it is none
  List::const_iterator begin() const;
  /// returns the end of a list.
  List::const_iterator end() const;
  /// returns the figure with a name; appends one that is nothing if there is none. The reference is
  /// valid until a figure is appended beside it.
  /// \pre it is figures, or nothing
  Report& operator[](std::string_view name);
  /// tells whether there is a figure with a name.
  bool contains(std::string_view name) const { return find(name) != nullptr; }
  /// returns the figure with a name. \throws std::out_of_range if there is none
  const Report& at(std::string_view name) const;

private:
  const Report* find(std::string_view name) const;

  Value value_;
};

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_SUPPORT_REPORT_H
