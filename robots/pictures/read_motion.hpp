#pragma once

#include <map>
#include <string>
#include <vector>

namespace treeline::pictures {

/// A recorded motion: the columns of a CSV file by name, all of one length.
using Motion = std::map<std::string, std::vector<double>>;

/// Reads a table as the experiments write it: a line of names, then lines of numbers, separated by
/// commas. Empty, with the reason in `error`, when the file is missing or not such a table.
Motion read_motion(const std::string& path, std::string& error);

}  // namespace treeline::pictures
