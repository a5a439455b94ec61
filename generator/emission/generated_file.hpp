#pragma once

#include <string>

namespace treeline {

/// A file of the generated folder; `name` is relative to it and has no directory.
struct GeneratedFile {
  std::string name;
  std::string text;
};

}  // namespace treeline
