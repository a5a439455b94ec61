#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "text/diagnostic.hpp"

namespace treeline {

/// Content that a diagnostic must have: everything that a user needs for correcting the file.
struct Expected {
  Severity severity = Severity::error;
  int line = 0;
  std::string element;  ///< the whole path
  std::string fault;    ///< part of it
  std::string remedy;   ///< part of it
};

inline std::string to_string(const Diagnostics& diagnostics) {
  std::string text;
  for (const Diagnostic& diagnostic : diagnostics.list()) text += to_string(diagnostic) + "\n";
  return text;
}

inline void expect_diagnosed(const Diagnostics& diagnostics, const std::string& file,
                             const Expected& expected) {
  const auto matches = [&](const Diagnostic& d) {
    return d.severity == expected.severity && d.file == file && d.line == expected.line &&
           d.element == expected.element && d.fault.find(expected.fault) != std::string::npos &&
           d.remedy.find(expected.remedy) != std::string::npos;
  };
  const auto& list = diagnostics.list();
  EXPECT_TRUE(std::any_of(list.begin(), list.end(), matches))
      << "expected at line " << expected.line << ": " << expected.element << ": " << expected.fault
      << "\n  " << expected.remedy << "\nbut there is\n"
      << to_string(diagnostics);
}

}  // namespace treeline
