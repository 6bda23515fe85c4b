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

/// adds an arithmetic to the study. Define an object of it with static storage, in your own source.
struct Registered_arithmetic {
  /// registers an arithmetic.
  /// \param name its name in `--arithmetic` and in results; no other arithmetic has this name
  /// \param study the function that runs it: `measure_and_compare<Traits>` of measure.h
  Registered_arithmetic(std::string name, void (*study)(Study_run&));
};

// Kinds of arithmetics, each in a source of its own. Only these sources contain the names.

/// returns the arithmetics of the processor, with and without tolerances.
std::vector<Arithmetic> hardware_arithmetics();
/// returns intervals alone, which may leave signs open.
std::vector<Arithmetic> interval_arithmetics();
/// returns floating point numbers with more bits, and exact number types.
std::vector<Arithmetic> number_types();
/// returns the exact arithmetics of this package.
std::vector<Arithmetic> certified_arithmetics();

} // namespace program

#endif // INTRINSIC_STUDY_ARITHMETICS_H
