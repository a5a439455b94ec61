#pragma once

#include <optional>
#include <string>

#include "description/flat/flat_model.hpp"
#include "text/diagnostic.hpp"

namespace treeline {

/// Well-formed XML, the path of its file, and what messages call it.
struct SdfText {
  std::string text, path, shown;
};

/// Type of the function that the module `treeline_sdf.so` exports as `kSdfReader`: see `read_sdf`.
using SdfReader = void(const SdfText& text, std::optional<FlatModel>& model,
                       Diagnostics& diagnostics);
inline constexpr const char* kSdfReader = "treeline_read_sdf";

}  // namespace treeline
