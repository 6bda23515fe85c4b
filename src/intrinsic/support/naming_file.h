// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_SUPPORT_NAMING_FILE_H
#define INTRINSIC_SUPPORT_NAMING_FILE_H

#include <CGAL/Intrinsic_triangulations/support/Invalid_input.h>

#include <stdexcept>
#include <string>

namespace program {

/// calls a function on the contents of a file, and puts the file's name before its errors.
template <class Function>
auto naming_file(const std::string& file, const Function& function) {
  namespace IT = CGAL::Intrinsic_triangulations;
  try {
    return function();
  } catch (const IT::Invalid_input& e) {
    throw IT::Invalid_input(e.kind(), e.index(), file + ": " + e.what());
  } catch (const std::invalid_argument& e) {
    throw std::runtime_error(file + ": " + e.what());
  }
}

} // namespace program

#endif // INTRINSIC_SUPPORT_NAMING_FILE_H
