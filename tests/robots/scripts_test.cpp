// Scripts of `treeline drive` beside the robots, each run as its head says. Would catch: a script
// that is refused or ends in a fault, one whose start is not the pose that it states, a point that
// does not arrive, and a body that passes through another.
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <regex>
#include <sstream>
#include <vector>

#include "../cli/run_program.hpp"
#include "../own_folder.hpp"
#include "overlaps/find_overlaps.hpp"

namespace treeline::experiments {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

/// A script, and the files that its head gives to `treeline drive`.
struct DriveScript {
  fs::path path;
  std::string urdf;
  std::string scene;

  friend void PrintTo(const DriveScript& script, std::ostream* out) {
    *out << script.path.filename().string();
  }
};

std::vector<DriveScript> find_scripts() {
  const std::regex head("#   treeline drive (\\S+) (\\S+) --script (\\S+)");
  std::vector<DriveScript> scripts;
  for (const auto& entry : fs::recursive_directory_iterator(TREELINE_ROBOTS_DIR)) {
    const fs::path& path = entry.path();
    const std::string text = path.extension() == ".txt" ? test::read_file(path) : "";
    std::smatch found;
    if (!std::regex_search(text, found, head)) continue;
    EXPECT_EQ(found[3], path.filename().string());
    const fs::path folder = path.parent_path();
    scripts.push_back(
        {path, (folder / found[1].str()).string(), (folder / found[2].str()).string()});
  }
  return scripts;
}

class DriveScripts : public test::OwnFolder, public testing::WithParamInterface<DriveScript> {
 protected:
  /// Drives by the script. Returns the record's lines.
  [[nodiscard]] std::vector<json> drive() const {
    const DriveScript& script = GetParam();
    const std::string record = (root_ / "record.jsonl").string();
    const test::Outcome outcome = test::run_program(
        root_, "drive '" + script.urdf + "' '" + script.scene + "' --headless --script '" +
                   script.path.string() + "' --record '" + record + "'");
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    std::vector<json> lines;
    std::istringstream stream(test::read_file(record));
    for (std::string line; std::getline(stream, line);) lines.push_back(json::parse(line));
    return lines;
  }

  /// The record from the first command on that moves no joint: the start has been reached.
  [[nodiscard]] std::string write_from_the_start_on(const std::vector<json>& lines) const {
    std::string text = lines.at(0).dump() + "\n";
    bool started = false;
    for (const json& line : lines) {
      const bool command = line["type"] == "command";
      const std::string said = command ? line["text"] : "";
      started =
          started || (command && said != "start" && said != "wait" && !said.starts_with("joint "));
      if (started) text += line.dump() + "\n";
    }
    write("motion.jsonl", text);
    return (root_ / "motion.jsonl").string();
  }
};

INSTANTIATE_TEST_SUITE_P(All, DriveScripts, testing::ValuesIn(find_scripts()),
                         [](const auto& tested) { return tested.param.path.stem().string(); });

/// The last state before the first command that moves no joint.
json state_at_start(const std::vector<json>& lines) {
  json state;
  for (const json& line : lines) {
    if (line["type"] == "state") state = line;
    if (line["type"] != "command") continue;
    const std::string said = line["text"];
    if (said != "start" && said != "wait" && !said.starts_with("joint ")) break;
  }
  return state;
}

/// The last state under control: at the end of a script the drive brakes and is idle.
json last_running(const std::vector<json>& lines) {
  const auto found = std::find_if(lines.rbegin(), lines.rend(), [](const json& line) {
    return line["type"] == "state" && line["mode"] == "running";
  });
  return found == lines.rend() ? json() : *found;
}

TEST_P(DriveScripts, RunAsTheirHeadsSay) {
  const std::vector<json> lines = drive();
  ASSERT_GT(lines.size(), 100U);
  const json& hello = lines.front();
  const json start = state_at_start(lines);
  const std::regex joint("joint (\\S+) to (\\S+) in .*");
  for (const json& line : lines) {
    if (line["type"] != "command") continue;
    EXPECT_TRUE(line["ok"].get<bool>()) << line;
    const std::string said = line["text"];
    std::smatch stated;
    if (!std::regex_match(said, stated, joint)) continue;
    for (std::size_t i = 0; i < hello["coordinates"].size(); ++i) {
      if (hello["coordinates"][i]["name"] != stated[1].str()) continue;
      EXPECT_NEAR(start["q"][i].get<double>(), std::stod(stated[2]), 1e-3) << said;
    }
  }
  const json end = last_running(lines);
  EXPECT_EQ(lines.back()["fault"], "");
  for (const json& point : end["points"]) {
    for (std::size_t i = 0; i < 3; ++i) {
      EXPECT_NEAR(point["at"][i].get<double>(), point["goal"][i].get<double>(), 1e-3);
    }
  }
  OverlapQuestion question;
  question.robot = GetParam().urdf;
  question.scene = GetParam().scene;
  question.motion = write_from_the_start_on(lines);
  question.left_out =
      read_left_out((fs::path(GetParam().urdf).parent_path() / "may_overlap.txt").string());
  Diagnostics diagnostics;
  const auto overlaps = find_overlaps(question, diagnostics);
  ASSERT_TRUE(overlaps) << to_string(diagnostics.list().front());
  for (const Overlap& overlap : *overlaps) {
    EXPECT_LE(overlap.depth, kAllowedOverlap)
        << overlap.first << " in " << overlap.second << " at " << overlap.time << " s";
  }
}

TEST(DriveScriptsOfRobots, AreFound) {
  EXPECT_GE(find_scripts().size(), 7U);
}

}  // namespace
}  // namespace treeline::experiments
