#pragma once

#include <string>
#include <vector>

#include "description/robot.hpp"
#include "description/scene.hpp"
#include "reproducibility/reproduce.hpp"

namespace treeline::tests {

/// One function in a language against the same function in another, compiled by one pair of
/// compilers.
struct LanguageRow {
  std::string robot, function, compilers, flags;
  int states = 0;       ///< number of states in which both were called
  int bits_differ = 0;  ///< number of these in which any bit of any result differs
};

/// A pair of compilers, of the one language and of the other: by default C++ and C. Entries of
/// OpenCL C are compiled as C++.
struct Compilers {
  std::string first, second;
  Language language = Language::cpp, other = Language::c;
};

/// How both languages are generated beside what a scene says, and compiled.
struct Manner {
  Profile profile = Profile::plain;
  int batch = 0;  ///< states a call of further functions; 0: none
  const char* level = "-O2";
};

/// Generates the scene's functions, and limited_control_torque where it has limits, in both
/// languages, compiles both with `flags`, calls them in the same states of all classes and compares
/// bits. Throws std::runtime_error if something cannot be generated or compiled.
std::vector<LanguageRow> compare_languages(const Robot& robot, const Scene& scene,
                                           const Compilers& compilers, const std::string& flags,
                                           int states);

/// Reads a URDF and, if it has a name, a scene, with these functions instead if there are any, and
/// compares without contraction. Throws std::runtime_error.
std::vector<LanguageRow> compare_languages_of(const std::string& urdf, const std::string& scene,
                                              const std::vector<Function>& functions, Real real,
                                              int lanes, const Compilers& compilers, int states,
                                              const Manner& manner = {});

}  // namespace treeline::tests
