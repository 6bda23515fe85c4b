// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "functions_as_tests.h"

#include <boost/core/demangle.hpp>

#include <cstddef>
#include <string>

namespace functions_as_tests {

namespace {

class Function_test : public testing::Test {
public:
  explicit Function_test(Function run) : run_(run) {}
  void TestBody() override { run_(); }

private:
  Function run_;
};

void add(const char* suite, const char* name, const char* type, const char* file, int line,
         Function run) {
  testing::RegisterTest(suite, name, type, nullptr, file, line,
                        [run]() -> testing::Test* { return new Function_test(run); });
}

} // namespace

bool add(const char* suite, const char* name, const char* file, int line, Function run) {
  add(suite, name, nullptr, file, line, run);
  return true;
}

bool add(const char* suite, const char* name, const char* file, int line,
         std::span<const Typed_function> tests) {
  for (std::size_t i = 0; i < tests.size(); ++i) {
    const std::string type = boost::core::demangle(tests[i].type->name());
    add((std::string(suite) + "/" + std::to_string(i)).c_str(), name, type.c_str(), file, line,
        tests[i].run);
  }
  return true;
}

} // namespace functions_as_tests
