#include "data/list_data.hpp"

#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>

namespace treeline::tests {

std::string data_folder() {
  return TREELINE_DATA_DIR;
}

std::string data_file(const std::string& name) {
  const std::string path = data_folder() + "/" + name;
  if (!std::filesystem::is_regular_file(path)) throw std::runtime_error("there is no " + path);
  return path;
}

std::vector<DataSource> data_sources() {
  std::vector<DataSource> sources;
  std::ifstream table(data_file("SOURCES.tsv"));
  std::string line;
  std::getline(table, line);
  while (std::getline(table, line)) {
    std::istringstream columns(line);
    DataSource row;
    for (std::string* column :
         {&row.file, &row.repository, &row.path, &row.commit, &row.licence, &row.remark}) {
      if (!std::getline(columns, *column, '\t') || column->empty()) {
        throw std::runtime_error("SOURCES.tsv: a column is missing in: " + line);
      }
    }
    sources.push_back(row);
  }
  return sources;
}

std::vector<DataRobot> data_robots(const std::string& folder) {
  std::vector<DataRobot> robots;
  for (const DataSource& source : data_sources()) {
    const std::filesystem::path file = source.file;
    if (file.parent_path() != folder || file.extension() != ".urdf") continue;
    robots.push_back({folder + "/" + file.stem().string(), data_file(source.file)});
  }
  if (robots.empty()) throw std::runtime_error("no robots in " + data_folder() + "/" + folder);
  return robots;
}

}  // namespace treeline::tests
