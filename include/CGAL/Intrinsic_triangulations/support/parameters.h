// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_SUPPORT_PARAMETERS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_SUPPORT_PARAMETERS_H

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/properties.h>

#include <boost/property_map/property_map.hpp>

#include <concepts>
#include <cstdint>
#include <functional>
#include <optional>
#include <type_traits>

/*!
\file
Named parameters: all functions of the package take options this way. They are chained in any order,

delaunay_refine(t, parameters::minimum_angle(30).visitor(std::ref(progress)));

The function documents the meaning of a name and its default. Visitors are copied; pass
`std::ref(v)` to call `v` itself. A name that the function does not have is a compile error.
Functions accept `CGAL::parameters`, too. Names of this package cannot continue a chain of CGAL, but
all names, also those of CGAL, are here.
*/

/// \cond
// Each name with the kind of its value, a concept of `internal`, and with what messages call that.
// clang-format off
#define CGAL_INTRINSIC_TRIANGULATIONS_PARAMETERS(name)                                             \
  name(edge_is_constrained_map, Property_map, "a property map from edges to bool")                 \
  name(visitor, Object, "an object, or std::ref() of one, with the members that the page lists")   \
  name(maximum_number, Number, "a number")                                                         \
  name(minimum_angle, Number, "a number of degrees")                                               \
  name(maximum_circumradius, Number, "a length, a number")                                         \
  name(maximum_edge_length, Number, "a length, a number")                                          \
  name(maximum_insertions, Number_or_none, "a number, or std::nullopt for no cap")                 \
  name(order, Enumerator, "a Refinement_order")                                                    \
  name(conforming, Flag, "true or false")                                                          \
  name(number_of_iterations, Number, "a number")                                                   \
  name(convergence, Number, "a number")                                                            \
  name(tolerance, Number, "a number")                                                              \
  name(bulk, Number, "a number from 0 to 1")                                                       \
  name(maximum_vertices, Number, "a number")                                                       \
  name(maximum_rounds, Number, "a number")                                                         \
  name(triangle_inequality, Enumerator, "a Triangle_inequality")                                   \
  name(margin, Number, "a number")                                                                 \
  name(maximum_faces, Number, "a number")                                                          \
  name(snaps_to_vertices, Flag, "true or false")                                                   \
  name(border_condition, Enumerator, "a Border_condition, or a Heat_border")                       \
  name(use_binary_mode, Flag, "true or false")                                                     \
  name(lines, Flag_or_object, "true, false or a range of lines")                                   \
  name(relative_length, Number, "a number from 0 to 1")                                            \
  name(minimum_joint_angle, Number, "a number of degrees")                                         \
  name(maximum_distance, Number, "a length, a number")                                             \
  name(targets, Object, "a vertex of t.mesh(), a Surface_point, or a range of them")               \
  name(shortest, Flag, "true or false")                                                            \
  name(time_factor, Number, "a number")                                                            \
  name(number_of_threads, Number, "a number")
// clang-format on
/// \endcond

namespace CGAL::Intrinsic_triangulations {

namespace internal {

/// \cond
namespace tags {
#define CGAL_INTRINSIC_TRIANGULATIONS_TAG(name, kind, words)                                       \
  struct name {};
CGAL_INTRINSIC_TRIANGULATIONS_PARAMETERS(CGAL_INTRINSIC_TRIANGULATIONS_TAG)
#undef CGAL_INTRINSIC_TRIANGULATIONS_TAG
} // namespace tags
/// \endcond

// Kinds of values. What a function makes of one is known where it reads it: see `value_or()`.
template <class T>
concept Number = (!std::is_enum_v<T> || std::convertible_to<T, int>)&&!std::is_same_v<T, bool> &&
                 requires(const T& x) {
  static_cast<double>(x);
};
template <class T>
concept Number_or_none = Number<T> || std::convertible_to<T, std::optional<std::uint64_t>>;
template <class T> // a text would be true
concept Flag = std::is_integral_v<T> ||(std::is_class_v<T>&& std::convertible_to<T, bool>);
template <class T>
concept Enumerator = std::is_enum_v<T>;
template <class T> // also a pointer, as descriptors may be
concept Object = std::is_class_v<T> || std::is_pointer_v<T>;
template <class T>
concept Flag_or_object = Flag<T> || Object<T>;
template <class T>
concept Property_map = requires {
  typename boost::property_traits<T>::key_type;
};

template <class Tag, class T>
struct Parameter {
  using tag = Tag;
  T object;
};

// the value of a name: overload resolution finds the base class
template <class Tag, class T>
const T& given(const Parameter<Tag, T>& p) {
  return p.object;
}
template <class Tag, class Parameters>
concept Has_parameter = requires(const Parameters& p) {
  internal::given<Tag>(p);
};

} // namespace internal

namespace parameters {

/*!
\brief is a chain of named parameters; each name is a member that continues the chain.
\tparam P the given values
*/
template <class... P>
  requires(requires { typename P::tag; } && ...)
class Parameters : public P... {
public:
  /// chains the given values.
  constexpr explicit Parameters(const P&... p) : P(p)... {}

  /// \cond
#define CGAL_INTRINSIC_TRIANGULATIONS_MEMBER(name, kind, words)                                    \
  template <class T>                                                                               \
  constexpr auto name(const T& value) const {                                                      \
    static_assert(internal::kind<T>, #name "() takes " words);                                     \
    return with<internal::tags::name>(value);                                                      \
  }
  CGAL_INTRINSIC_TRIANGULATIONS_PARAMETERS(CGAL_INTRINSIC_TRIANGULATIONS_MEMBER)
#undef CGAL_INTRINSIC_TRIANGULATIONS_MEMBER
  /// \endcond

private:
  template <class Tag, class T>
  constexpr auto with(const T& value) const {
    static_assert(!internal::Has_parameter<Tag, Parameters>, "a named parameter is given twice");
    using New = internal::Parameter<Tag, T>;
    return Parameters<P..., New>(static_cast<const P&>(*this)..., New{value});
  }
};

/// returns the empty chain: all parameters have their defaults.
inline Parameters<> default_values() { return Parameters<>(); }

/// \cond
#define CGAL_INTRINSIC_TRIANGULATIONS_FUNCTION(name, kind, words)                                  \
  template <class T>                                                                               \
  constexpr auto name(const T& value) {                                                            \
    return Parameters<>().name(value);                                                             \
  }
CGAL_INTRINSIC_TRIANGULATIONS_PARAMETERS(CGAL_INTRINSIC_TRIANGULATIONS_FUNCTION)
#undef CGAL_INTRINSIC_TRIANGULATIONS_FUNCTION
/// \endcond

} // namespace parameters

namespace internal {

template <class T>
inline constexpr bool is_named_parameters = false;
template <class... P>
inline constexpr bool is_named_parameters<parameters::Parameters<P...>> = true;
template <class T, class Tag, class Base>
inline constexpr bool is_named_parameters<Named_function_parameters<T, Tag, Base>> = true;

// CGAL's names among ours
constexpr auto cgal_name(tags::visitor) { return CGAL::internal_np::visitor; }
constexpr auto cgal_name(tags::edge_is_constrained_map) {
  return CGAL::internal_np::edge_is_constrained;
}
constexpr auto cgal_name(tags::maximum_number) { return CGAL::internal_np::maximum_number; }
constexpr auto cgal_name(tags::number_of_iterations) {
  return CGAL::internal_np::number_of_iterations;
}
constexpr auto cgal_name(tags::use_binary_mode) { return CGAL::internal_np::use_binary_mode; }
template <class T, class CGAL_tag, class Base, class Tag>
auto cgal_parameter(const Named_function_parameters<T, CGAL_tag, Base>& np,
                    Tag tag) requires requires {
  cgal_name(tag);
}
{ return CGAL::parameters::get_parameter(np, cgal_name(tag)); }

// A copy of the value of a name, or of the default, of any type.
template <class Tag, class NamedParameters, class Default>
auto object_or(const NamedParameters& np, const Default& otherwise) {
  if constexpr (Has_parameter<Tag, NamedParameters>)
    return given<Tag>(np);
  else if constexpr (requires { cgal_parameter(np, Tag()); }) {
    using Given = decltype(cgal_parameter(np, Tag()));
    if constexpr (std::is_same_v<Given, CGAL::internal_np::Param_not_found>)
      return otherwise;
    else
      return cgal_parameter(np, Tag());
  } else
    return otherwise;
}

// The map of constrained edges that was given, or one without any.
template <class Edge, class NamedParameters>
auto constrained_map(const NamedParameters& np) {
  const auto map =
      object_or<tags::edge_is_constrained_map>(np, Static_boolean_property_map<Edge, false>());
  using Key = typename boost::property_traits<std::remove_const_t<decltype(map)>>::key_type;
  static_assert(std::is_convertible_v<Edge, Key>,
                "edge_is_constrained_map() takes a map from edges of the triangulation: "
                "constrained_input_edges(t, mesh, map) makes one of a map from edges of your mesh");
  return map;
}

// The value of a name, or the default, in the type of the default.
template <class Tag, class NamedParameters, class Default>
Default value_or(const NamedParameters& np, const Default& otherwise) {
  using Given = decltype(object_or<Tag>(np, otherwise));
  static_assert(std::is_same_v<Given, Default> || !std::is_enum_v<Default>,
                "this function takes a value of another enumeration for one of its named "
                "parameters; see its page");
  return static_cast<Default>(object_or<Tag>(np, otherwise));
}

// The object behind a visitor passed by `std::ref()`.
template <class T>
T& unwrapped(T& value) {
  return value;
}
template <class T>
T& unwrapped(std::reference_wrapper<T>& reference) {
  return reference.get();
}

// Always goes on.
struct Silent_visitor {
  template <class... Reported>
  bool progress(const Reported&...) const {
    return true;
  }
};

// Calls the given visitor, or none, for functions that are not templates.
template <class NamedParameters>
auto progress_of(const NamedParameters& np) {
  return [v = object_or<tags::visitor>(np, Silent_visitor())](auto reported) mutable {
    return unwrapped(v).progress(reported);
  };
}

template <class Tag, class... Tags>
inline constexpr bool is_one_of = (std::is_same_v<Tag, Tags> || ...);

// Refuses a name that a function does not have: compilers print `Unknown_parameter`.
template <class Unknown_parameter, class... Tags>
constexpr void expect_name() {
  static_assert(is_one_of<Unknown_parameter, Tags...>,
                "this function does not have one of the named parameters that are given: the one "
                "that the compiler shows as `Unknown_parameter`; see the page of the function");
}

// Refuses names that a function does not have.
template <class... Tags, class... P>
constexpr void expect_names(const parameters::Parameters<P...>&) {
  (expect_name<typename P::tag, Tags...>(), ...);
}
template <class Tag>
struct Name_of_cgal {
  using type = Tag; // there is none
};
template <class Tag>
  requires requires { cgal_name(Tag()); }
struct Name_of_cgal<Tag> {
  using type = decltype(cgal_name(Tag()));
};
template <class... Tags, class T, class Tag, class Base>
constexpr void expect_names(const Named_function_parameters<T, Tag, Base>& np) {
  if constexpr (!std::is_same_v<Tag, CGAL::internal_np::all_default_t>)
    expect_name<Tag, typename Name_of_cgal<Tags>::type...>();
  if constexpr (!std::is_same_v<Base, CGAL::internal_np::No_property>)
    expect_names<Tags...>(static_cast<const Base&>(np));
}

} // namespace internal

/*!
\brief requires named parameters: a chain of `parameters` or of `CGAL::parameters`.

Syntax of \ref ::NamedParameters, which describes its meaning.
*/
template <class T>
concept NamedParameters = internal::is_named_parameters<T>;

} // namespace CGAL::Intrinsic_triangulations

#undef CGAL_INTRINSIC_TRIANGULATIONS_PARAMETERS

#endif // CGAL_INTRINSIC_TRIANGULATIONS_SUPPORT_PARAMETERS_H
