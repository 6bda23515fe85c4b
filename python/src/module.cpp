// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Surface.h"

#include <CGAL/Intrinsic_triangulations/IO/support/Replacing_file.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstddef>
#include <exception>
#include <stdexcept>
#include <string>
#include <string_view>

namespace python {

namespace {

// Options in messages of the program, as Python has them.
std::string in_python(std::string message) {
  static constexpr std::array<std::array<std::string_view, 2>, 18> names{
      {{"--arithmetic exact", "arithmetic=\"exact\""},
       {"--domain points", "intrinsic.points(points)"},
       {"--domain tufted", "domain=\"tufted\""},
       {"--domain orientation-cover", "domain=\"orientation-cover\""},
       {"--arithmetic", "arithmetic"},
       {"--mollification", "mollification"},
       {"--domain", "domain"},
       {"--neighbors", "neighbors"},
       {"--polygons", "polygons"},
       {"--method spectral", "method=\"spectral\""},
       {"--method affine", "method=\"affine\""},
       {"--method exact", "method=\"exact\""},
       {"--time-factor", "time_factor"},
       {"--max-distance", "max_distance"},
       {"--method", "method"},
       {"--align", "align"},
       {"--degree", "degree"},
       {"--source", "source"}}};
  for (const auto& [option, name] : names)
    for (std::size_t i; (i = message.find(option)) != std::string::npos;)
      message.replace(i, option.size(), name);
  return message;
}

// `OSError`, or what Python calls the error of the system, such as `FileNotFoundError`, with the
// name of the file.
void set_os_error(const IT::File_error& error) {
  const std::string path = error.path().string(), said = error.what();
  const std::string what = said.substr(std::min(said.size(), path.size() + 2)); // after the name
  const py::object kind = py::reinterpret_borrow<py::object>(PyExc_OSError);
  const py::object raised = kind(error.code() ? error.code().value() : EIO, what, path);
  PyErr_SetObject(py::type::handle_of(raised).ptr(), raised.ptr());
}

// Errors that name what is wrong with an argument become `ValueError`, those of files `OSError`.
// pybind11 does the rest: `std::bad_alloc` becomes `MemoryError`.
void translate(std::exception_ptr e) {
  try {
    if (e) std::rethrow_exception(e);
  } catch (const IT::Invalid_input& error) {
    PyErr_SetString(PyExc_ValueError, in_python(error.what()).c_str());
  } catch (const py::builtin_exception&) {
    throw;
  } catch (const IT::File_error& error) {
    set_os_error(error);
  } catch (const std::runtime_error& error) {
    PyErr_SetString(PyExc_RuntimeError, in_python(error.what()).c_str());
  }
}

} // namespace

PYBIND11_MODULE(_core, m) {
  m.attr("__version__") = INTRINSIC_TRIANGULATIONS_VERSION;
  m.doc() = "What the package intrinsic has compiled; use the package instead.";
  py::register_exception_translator(translate);
  bind_surface(m);
  bind_improve(m);
  bind_queries(m);
  bind_subdivision(m);
  bind_distances(m);
  bind_curves(m);
  bind_fields(m);
  bind_maps(m);
  bind_simplify(m);
  bind_isometries(m);
  bind_pages(m);
  bind_files(m);
}

} // namespace python
