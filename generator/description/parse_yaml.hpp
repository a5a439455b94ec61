#pragma once

#include <yaml-cpp/yaml.h>

#include <optional>
#include <string>

#include "text/diagnostic.hpp"

namespace treeline {

/// The one YAML document in `text`; an empty map when there is none. Nothing, and an error, when
/// the text has more than 1 MiB, is not UTF-8, not well-formed, more than one document or has tags.
std::optional<YAML::Node> parse_yaml(const std::string& text, const std::string& file,
                                     Diagnostics& diagnostics);

}  // namespace treeline
