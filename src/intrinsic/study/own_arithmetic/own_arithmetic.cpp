// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Adds an arithmetic of your own to the study. You need only a source like this one, anywhere:
// configure with -DINTRINSIC_TRIANGULATIONS_STUDY_SOURCES=own_arithmetic.cpp, and build
// `intrinsic-study`.

#include <boost/multiprecision/cpp_bin_float.hpp>

#include <CGAL/Intrinsic_triangulations/metric/boost_float_traits.h>

#include <arithmetics.h>
#include <measure.h>

namespace {

//! [own arithmetic]
using Float_64 = boost::multiprecision::number<
    boost::multiprecision::cpp_bin_float<64, boost::multiprecision::digit_base_2>,
    boost::multiprecision::et_off>;

const program::Registered_arithmetic
    mine("boost-64", program::measure_and_compare<program::IT::Euclidean_traits<Float_64>>);
//! [own arithmetic]

} // namespace
