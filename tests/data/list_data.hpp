#pragma once

#include <string>
#include <vector>

/// The files of tests/data.
namespace treeline::tests {

/// A row of SOURCES.tsv: the source of a file. `-` if a column does not apply.
struct DataSource {
  std::string file;  ///< relative to tests/data
  std::string repository, path, commit, licence, remark;
};

struct DataRobot {
  std::string name;  ///< `published/fetch`
  std::string path;  ///< of its URDF
};

/// The folder tests/data.
std::string data_folder();

/// Absolute path of a file, given its path in tests/data. Throws std::runtime_error if it does not
/// exist, so that a test without its data fails.
std::string data_file(const std::string& name);

/// All rows in the table's order. Throws std::runtime_error if a row lacks a column.
std::vector<DataSource> data_sources();

/// The robots of a folder, `published`, `golden` or `odd`, by name. Throws like data_file.
std::vector<DataRobot> data_robots(const std::string& folder);

}  // namespace treeline::tests
