#pragma once

#include <ostream>
#include <string>

namespace treeline {

/// A text of a scene, part of what is said of it, and part of what is to be done.
struct SceneFault {
  std::string text;
  const char* fault;
  const char* remedy;
};

// Names of tests have no quotation marks.
inline void PrintTo(const SceneFault& tested, std::ostream* out) {
  for (const char* c = tested.fault; *c != '\0'; ++c) *out << (*c == '"' ? '`' : *c);
}

}  // namespace treeline
