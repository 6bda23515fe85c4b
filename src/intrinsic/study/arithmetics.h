// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_STUDY_ARITHMETICS_H
#define INTRINSIC_STUDY_ARITHMETICS_H

#include <string>
#include <vector>

namespace program {

struct Study_run;

/// What the study compares.
struct Arithmetic {
  std::string name;
  /// runs it. \throws Invalid_input if it cannot hold the values of the input
  void (*study)(Study_run&);
};

/// returns all of them, in the order of the study.
const std::vector<Arithmetic>& arithmetics();

/// adds one to the study: to be defined with static storage, in a source of one's own.
struct Registered_arithmetic {
  /// registers an arithmetic.
  /// \param name what `--arithmetic` and results call it, which no other is called
  /// \param study how it is run: `measure_and_compare<Traits>` of measure.h
  Registered_arithmetic(std::string name, void (*study)(Study_run&));
};

// Kinds of them, each in a translation unit of its own, to compile in little memory. The names stand
// there and nowhere else.

/// returns those that the processor computes in, with and without tolerances.
std::vector<Arithmetic> hardware_arithmetics();
/// returns intervals without anything that decides where they do not.
std::vector<Arithmetic> interval_arithmetics();
/// returns floating point numbers with more bits.
std::vector<Arithmetic> boost_arithmetics();
/// returns exact number types.
std::vector<Arithmetic> exact_number_types();
/// returns those that this package decides exactly in.
std::vector<Arithmetic> certified_arithmetics();

} // namespace program

#endif // INTRINSIC_STUDY_ARITHMETICS_H
