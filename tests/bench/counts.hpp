#pragma once

#include <map>
#include <string>

namespace treeline::bench {

/// Instructions a call, by "robot/function": what count_instructions.sh printed into a file.
std::map<std::string, long> read_counts(const std::string& path);

}  // namespace treeline::bench
