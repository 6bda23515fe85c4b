// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_PYTHON_KEPT_HEAT_H
#define INTRINSIC_PYTHON_KEPT_HEAT_H

#include "Surface.h"

#include <CGAL/Intrinsic_operators/distance/Heat_solver.h>
#include <CGAL/Intrinsic_triangulations/connectivity/Status.h>
#include <CGAL/Intrinsic_triangulations/connectivity/parameters.h>

#include <memory>
#include <string>
#include <typeinfo>

// Distances by heat, whose matrices a surface keeps.

namespace python {

/// Asks whether to go on, on behalf of the call that uses a method at the time.
struct Heat_visitor {
  std::shared_ptr<Watch*> watch; ///< that of the call
  /// is called after each step.
  bool progress(IT::Heat_step) { return (**watch)("matrices"); }
};

/// A method with its factored matrices, for one factor of the time.
template <class Method>
struct Kept_heat {
  /// factors the matrices of a triangulation.
  template <class T>
  Kept_heat(const T& t, double factor, Watch* w)
      : time_factor(factor), watch(std::make_shared<Watch*>(w)),
        method(t, IT::parameters::time_factor(factor).visitor(Heat_visitor{watch})) {}

  double time_factor;            ///< the factor
  std::shared_ptr<Watch*> watch; ///< of the call that uses it
  Method method;                 ///< the matrices
};

/*!
\brief calls a function with a method of heat on the triangulation of a surface, which keeps it. If
the watch ends the work, it keeps nothing.
\tparam Method `Heat_distance` or `Signed_heat_distance`
*/
template <class Method, class T, class Function>
auto with_heat(Surface& s, const T& t, double time_factor, Watch& watch, const Function& f) {
  const std::string name = typeid(Method).name();
  if (const auto found = s.cache.find(name); found != s.cache.end())
    if (static_cast<Kept_heat<Method>*>(found->second.get())->time_factor != time_factor)
      s.cache.erase(found);
  auto& kept = s.cached<Kept_heat<Method>>(
      name, [&] { return std::make_unique<Kept_heat<Method>>(t, time_factor, &watch); });
  *kept.watch = &watch;
  auto result = f(kept.method);
  if (kept.method.status() == IT::Status::cancelled) s.cache.erase(name);
  return result;
}

} // namespace python

#endif // INTRINSIC_PYTHON_KEPT_HEAT_H
