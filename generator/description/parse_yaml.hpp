#pragma once

#include <yaml-cpp/yaml.h>

#include <map>
#include <optional>
#include <string>

#include "text/diagnostic.hpp"

namespace treeline {

/// The one YAML document in `text`; an empty map when there is none. Nothing, and an error, when
/// the text has more than 1 MiB, is not UTF-8, not well-formed, more than one document or has tags.
std::optional<YAML::Node> parse_yaml(const std::string& text, const std::string& file,
                                     Diagnostics& diagnostics);

/// The lines of the aliases (`*name`) in a YAML document that is well formed, by their places, such
/// as `operational_points[0]/link`. The library gives what an alias stands for the line of its
/// anchor, wherever it is used.
std::map<std::string, int> alias_lines(const std::string& text);

}  // namespace treeline
