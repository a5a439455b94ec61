#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

namespace treeline {

/// JSON in lines, two blanks a level, with a line break at the end. Bytes that are not UTF-8, as
/// names in files may have, become U+FFFD.
std::string json_text(const nlohmann::ordered_json& json);

/// JSON in one line, without a line break; bytes that are not UTF-8 become U+FFFD.
std::string json_line(const nlohmann::ordered_json& json);

}  // namespace treeline
