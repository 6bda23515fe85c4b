// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "options.h"
#include "support/file_formats.h"

namespace program {

bool is_mesh_output(const Options& options) {
  return is_file_of(Contents::subdivision, options.output);
}

bool has_constraints(const Options& options) {
  return options.sharp_angle || !options.constraints.empty();
}

bool needs_subdivision(const Options& options) {
  return is_mesh_output(options) || !options.view.empty() || !options.interpolation.empty() ||
         !options.input_interpolation.empty();
}

bool needs_correspondence(const Options& options) {
  return needs_subdivision(options) || !options.sizes.empty() || options.is_adaptive;
}

} // namespace program
