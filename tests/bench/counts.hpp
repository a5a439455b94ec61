#pragma once

#include <map>
#include <string>

namespace treeline::bench {

/// Reads the instructions per call, by "robot/function", from a file with the output of
/// count_instructions.sh.
std::map<std::string, long> read_counts(const std::string& path);

}  // namespace treeline::bench
