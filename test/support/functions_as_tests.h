// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_TRIANGULATIONS_TEST_FUNCTIONS_AS_TESTS_H
#define INTRINSIC_TRIANGULATIONS_TEST_FUNCTIONS_AS_TESTS_H

#include <gtest/gtest.h>

#include <span>
#include <typeinfo>

// `TEST` and `TYPED_TEST` as gtest has them, but tests are functions, which one class runs. gtest
// makes a class and a factory of each test, ten functions and two tables: a tenth of the time in
// which a test program compiles. The precompiled header of the tests includes this file; without
// it, tests are gtest's own.
//
// Fixtures of typed tests only name the suite: they must not have anything.

namespace functions_as_tests {

using Function = void (*)();

/// A test for one type.
struct Typed_function {
  Function run;
  const std::type_info* type;
};

/// Adds a test to those that the program runs.
bool add(const char* suite, const char* name, const char* file, int line, Function run);
/// Adds a test for each type to suites that are numbered.
bool add(const char* suite, const char* name, const char* file, int line,
         std::span<const Typed_function> tests);

/// Adds a test for each type of a list.
template <template <class> class Test, template <class...> class List, class... Types>
bool add_for_each(const List<Types...>*, const char* suite, const char* name, const char* file,
                  int line) {
  static const Typed_function tests[] = {{&Test<Types>::run, &typeid(Types)}...};
  return add(suite, name, file, line, tests);
}

} // namespace functions_as_tests

#undef TEST
#define TEST(suite, name)                                                                          \
  struct suite##_##name##_Test : ::testing::Test { /* never made: lends its static members */      \
    static void run();                                                                             \
  };                                                                                               \
  [[maybe_unused]] static const bool suite##_##name##_is_added =                                   \
      ::functions_as_tests::add(#suite, #name, __FILE__, __LINE__, &suite##_##name##_Test::run);   \
  void suite##_##name##_Test::run()

#undef TYPED_TEST_SUITE
#define TYPED_TEST_SUITE(suite, ...) using suite##_types = __VA_ARGS__

#undef TYPED_TEST
#define TYPED_TEST(suite, name)                                                                    \
  static_assert(sizeof(suite<int>) == sizeof(::testing::Test), "a fixture has members");           \
  template <class TypeParam>                                                                       \
  struct suite##_##name##_Test : ::testing::Test {                                                 \
    static void run();                                                                             \
  };                                                                                               \
  [[maybe_unused]] static const bool suite##_##name##_is_added =                                   \
      ::functions_as_tests::add_for_each<suite##_##name##_Test>(                                   \
          static_cast<suite##_types*>(nullptr), #suite, #name, __FILE__, __LINE__);                \
  template <class TypeParam>                                                                       \
  void suite##_##name##_Test<TypeParam>::run()

#endif // INTRINSIC_TRIANGULATIONS_TEST_FUNCTIONS_AS_TESTS_H
