#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <sstream>

#include "description/read_keys.hpp"
#include "emission/controller_unit.hpp"
#include "emission/emitted_text.hpp"
#include "generation/describe_scene.hpp"
#include "packaging/package_kinds.hpp"
#include "packaging/templates.hpp"
#include "target/target.hpp"

namespace treeline {
namespace {

namespace templates = package_templates;

/// How far the simulated arm is led, rad or m.
constexpr double kWay = 0.2;

/// Identifiers from 0x310, of goals, to 0x380, of the status.
constexpr int kMostJoints = 0x380 - 0x310;

/// Numbers as an array in C has them.
std::string list_numbers(const Scene& scene, const std::vector<double>& numbers) {
  std::vector<std::string> texts;
  for (const double number : numbers) {
    texts.push_back(fmt::format("{:.6f}{}", number, scene.real == Real::float32 ? "F" : ""));
  }
  return fmt::format("{{{}}}", fmt::join(texts, ", "));
}

/// The goal of a joint that stands at home, within its limits.
double choose_goal(const EmissionContext::CoordinateRow& row) {
  if (row.home + kWay <= row.upper) return row.home + kWay;
  return row.home - kWay >= row.lower ? row.home - kWay : row.home;
}

/// The folder's own sources, as the makefile lists them.
std::string list_own_sources(const PackageFacts& facts) {
  std::string text;
  std::istringstream words(facts.at("sources"));
  for (std::string word; words >> word;) {
    text += (text.empty() ? "" : " \\\n  ") + word.substr(3);  // without "../"
  }
  return text;
}

/// Options of the linker, for a compiler.
std::string place_memory_of(const Board& board) {
  std::string text;
  std::istringstream words(board.linker);
  for (std::string word; words >> word;) text += (text.empty() ? "-Wl," : " -Wl,") + word;
  return text;
}

}  // namespace

std::vector<PackageFolder> for_firmware(PackageFacts facts, const Robot& robot, const Scene& scene,
                                        const Generation& generation) {
  const EmissionContext context = describe_scene(robot, scene, generation.mechanism);
  const Target& target = *find_target(scene.target);
  std::vector<double> home, goal;
  for (const auto& row : context.coordinate_rows) {
    home.push_back(row.home);
    goal.push_back(choose_goal(row));
  }
  const bool tests = scene.selftest > 0;
  facts["rate"] = std::to_string(std::lround(1 / generation.controller->settings.period));
  facts["selftest_include"] = tests ? fmt::format("#include \"{}_selftest.h\"", scene.name) : "";
  facts["selftest"] = tests ? fmt::format(
                                  "if ({}_selftest() != 0) {{\n  return 1; /* the brakes stay "
                                  "closed */\n}}",
                                  scene.name)
                            : "";
  facts["home"] = list_numbers(scene, home);
  facts["goal"] = list_numbers(scene, goal);
  facts["clock_mhz"] = std::to_string(target.board.clock_mhz);
  facts["target"] = target.name;
  facts["target_flags"] = target.flags;
  facts["prefix"] = target.prefix;
  facts["simulator"] = fmt::format("{} {}", target.board.simulator, target.board.machine);
  facts["places"] = place_memory_of(target.board);
  facts["own_sources"] = list_own_sources(facts);
  const auto fill = [&](const char* name, std::string_view text) {
    return GeneratedFile{name, fill_holes(text, facts)};
  };
  return {
      {"",
       {fill("Makefile", templates::kFirmwareMakefile),
        fill("README.md", templates::kFirmwareReadme), fill("board.ld", templates::kLinkerScript),
        fill("can.c", templates::kFirmwareCan), fill("can.h", templates::kFirmwareCanHeader),
        fill("main.c", templates::kFirmwareMain), fill("port.h", templates::kFirmwarePort),
        fill("port_qemu.c", templates::kFirmwarePortQemu)}}};
}

void refuse_for_firmware(const Robot& robot, const Scene& scene, Diagnostics& diagnostics) {
  const auto refuse = [&](bool applies, const char* key, const char* fault, const char* remedy) {
    if (applies) diagnostics.add({Severity::error, scene.file, 0, key, fault, remedy});
  };
  refuse(!scene.controller, "controller", "firmware is made around its step, and there is none",
         "Write `controller: {laws: [joint_impedance]}`, or leave --package out.");
  refuse(
      find_target(scene.target)->board.kind != BoardKind::cortex_m, "target",
      "firmware is made for a Cortex-M",
      "Name the processor, such as --target cortex-m4f; main.c, can.c and port.h are the same on "
      "others.");
  refuse(
      std::count(scene.functions.begin(), scene.functions.end(), Function::forward_dynamics) == 0,
      "functions", "the arm that port_qemu.c simulates moves by `forward_dynamics`",
      "Add it: where it is not called it takes no memory.");
  refuse(!scene.inputs.empty(), "inputs", "the arm that port_qemu.c simulates has none",
         "Leave them out, or leave --package out.");
  refuse(!scene.external_forces.empty(), "external_forces",
         "the arm that port_qemu.c simulates has none", "Leave them out, or leave --package out.");
  const auto driven = [&](const Joint& joint) { return is_driven(joint, scene); };
  refuse(std::count_if(robot.joints.begin(), robot.joints.end(), driven) > kMostJoints,
         "controller", "frames of its CAN bus have identifiers for 112 joints, and there are more",
         "Lock some, or leave --package out.");
  refuse(scene.sin_cos == Sines::given, "sin_cos",
         "the arm that port_qemu.c simulates has no sines to give", "Leave it out.");
}

}  // namespace treeline
