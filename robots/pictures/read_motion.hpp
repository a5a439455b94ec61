#pragma once

#include <map>
#include <string>
#include <vector>

namespace treeline::pictures {

/// A recorded motion: the columns of a CSV file by name, all of the same length.
using Motion = std::map<std::string, std::vector<double>>;

/// Reads a table in the format of the experiments: a line of names, then lines of numbers,
/// separated by commas. Empty, with the reason in `error`, if the file is missing or is not such a
/// table.
Motion read_motion(const std::string& path, std::string& error);

}  // namespace treeline::pictures
