#include <fstream>
#include <nlohmann/json.hpp>

#include "cli/record.hpp"

namespace treeline {
namespace {

using Json = nlohmann::ordered_json;

/// Takes one line. False: it is no line of a record. `robot` is set to what the greeting says.
bool take_line(const std::string& line, Record& record, std::string& robot) {
  const Json json = Json::parse(line, nullptr, false);
  const std::string type = json.is_object() ? json.value("type", "") : "";
  if (type == "hello" && record.hello.empty()) {
    record.hello = line;
    robot = json.value("robot", "");
  } else if (type == "state" && json.contains("time") && json["time"].is_number()) {
    const double time = json["time"].get<double>();
    if (!record.times.empty() && time < record.times.back()) return false;
    record.times.push_back(time);
    record.states.push_back(line);
  } else if (type != "command") {
    return false;
  }
  return !record.hello.empty();
}

}  // namespace

bool is_table(const std::string& path) {
  std::ifstream stream(path, std::ios::binary);
  return stream && (stream >> std::ws).peek() != '{';
}

std::optional<Record> read_record(const std::string& path, const std::string& checksum,
                                  Diagnostics& diagnostics) {
  const auto refuse = [&](int line, std::string fault, std::string remedy) {
    diagnostics.add({Severity::error, path, line, "", std::move(fault), std::move(remedy)});
    return std::nullopt;
  };
  std::ifstream stream(path, std::ios::binary);
  if (!stream) return refuse(0, "cannot be read", "Name a file of `treeline drive --record`.");
  Record record;
  std::string robot;
  int number = 0;
  for (std::string line; std::getline(stream, line);) {
    ++number;
    if (take_line(line, record, robot)) continue;
    if (stream.eof() && !record.states.empty()) break;  // a drive that was killed in mid-line
    return refuse(number, "this is no line of a record",
                  "Give a file that `treeline drive --record` has written, or a table.");
  }
  if (record.states.empty()) {
    return refuse(0, "there is no state in it", "Record a drive that begins: --record FILE.");
  }
  if (robot != checksum) {
    return refuse(1, "this was recorded with another URDF or scene",
                  "Give the files that it was recorded with, unchanged.");
  }
  return record;
}

}  // namespace treeline
