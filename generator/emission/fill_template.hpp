#pragma once

#include <map>
#include <string>
#include <string_view>

namespace treeline {

/// `text` with every `{{hole}}` replaced by the value of that name. A hole that stands alone on its
/// line keeps its indentation for every line of the value; an empty value takes the line with it.
/// Throws std::logic_error when a hole has no value, a value has no hole, or a hole is not closed:
/// template and emitter have parted, a fault of the program.
std::string fill_template(std::string_view text, const std::map<std::string, std::string>& values);

/// Fills the holes of `text` as `fill_template` does; `values` may have more than it has holes.
std::string fill_holes(std::string_view text, const std::map<std::string, std::string>& values);

}  // namespace treeline
