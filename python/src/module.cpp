// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Surface.h"

#include <exception>
#include <new>
#include <stdexcept>

namespace python {

namespace {

// Errors that name what is wrong with an argument become `ValueError`. pybind11 does the rest:
// `std::bad_alloc` becomes `MemoryError`, other exceptions `RuntimeError`.
void translate(std::exception_ptr e) {
  try {
    if (e) std::rethrow_exception(e);
  } catch (const IT::Invalid_input& error) {
    PyErr_SetString(PyExc_ValueError, error.what());
  }
}

} // namespace

PYBIND11_MODULE(_core, m) {
  m.doc() = "What the package intrinsic has compiled; use the package instead.";
  py::register_exception_translator(translate);
  bind_surface(m);
  bind_distances(m);
  bind_curves(m);
  bind_fields(m);
  bind_maps(m);
}

} // namespace python
