// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef TEST_INTRINSIC_TRIANGULATIONS_NUMBER_ARCHETYPES_H
#define TEST_INTRINSIC_TRIANGULATIONS_NUMBER_ARCHETYPES_H

namespace archetypes {

/// A ring: only +, - and *.
class Ring_number {
public:
  struct Tag {};
  Ring_number(double x, Tag) : value(x) {}

  friend Ring_number operator+(const Ring_number& a, const Ring_number& b) {
    return {a.value + b.value, Tag()};
  }
  friend Ring_number operator-(const Ring_number& a, const Ring_number& b) {
    return {a.value - b.value, Tag()};
  }
  friend Ring_number operator*(const Ring_number& a, const Ring_number& b) {
    return {a.value * b.value, Tag()};
  }

  double value;
};

/// A field: no comparison, no default value.
class Field_number {
public:
  explicit Field_number(int x) : value(x) {}
  explicit Field_number(double x) : value(x) {}

  friend Field_number operator+(const Field_number& a, const Field_number& b) {
    return Field_number(a.value + b.value);
  }
  friend Field_number operator-(const Field_number& a, const Field_number& b) {
    return Field_number(a.value - b.value);
  }
  friend Field_number operator*(const Field_number& a, const Field_number& b) {
    return Field_number(a.value * b.value);
  }
  friend Field_number operator/(const Field_number& a, const Field_number& b) {
    return Field_number(a.value / b.value);
  }

  double value;
};

} // namespace archetypes

#endif // TEST_INTRINSIC_TRIANGULATIONS_NUMBER_ARCHETYPES_H
