// Would catch: commands that are accepted and end in a fault, or that lead a joint beyond 90 % of
// its limit of speed, whoever asks: goals out of reach, motions that are too short, pulls, drags,
// changes of the control in full swing. Ten thousand scripts take three quarters of an hour.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <memory>
#include <random>
#include <string>
#include <variant>
#include <vector>

#include "cli/read_inputs.hpp"
#include "description/read_urdf.hpp"
#include "drive/command.hpp"
#include "driving/find_start.hpp"
#include "driving/loop_handle.hpp"
#include "driving/robot_elsewhere.hpp"
#include "inspect/propose_scene.hpp"
#include "launch/launch.hpp"
#include "servo/safety.hpp"

namespace treeline {
namespace {

/// A robot of this repository; without a scene, one that `init-scene` proposes.
struct Tried {
  const char* name;
  const char* urdf;
  const char* scene;
  double most = 0.9;  ///< share of a limit of speed that no joint exceeds
  int faults = 0;     ///< known ones among the scripts by the thousand
};
constexpr Tried kTried[] = {
    {"planar3r", "robots/planar3r/planar3r.urdf", "robots/planar3r/scene.yaml"},
    {"puma560", "robots/puma560/puma560.urdf", "robots/puma560/scene.yaml"},
    {"ur10e", "robots/ur10e/ur10e.urdf", "robots/ur10e/scene.yaml"},
    {"samm", "robots/samm/samm.urdf", "robots/samm/scene.yaml"},
    {"humanoid24", "robots/humanoid24/humanoid24.urdf", "robots/humanoid24/scene.yaml", 0.9,
     1},  // seed 1695: its light right wrist goes 1 mrad beyond its range
    {"fr3", "tests/data/published/fr3.urdf", ""},
    {"panda", "tests/data/published/panda_hand.urdf", ""},
    {"iiwa14", "tests/data/published/iiwa14_drake.urdf", ""},
    {"ur5", "tests/data/published/ur5.urdf", ""},
    {"gen3", "tests/data/published/kinova_gen3_2f85.urdf", ""},
    {"nextage", "tests/data/published/nextage.urdf", ""},
    {"fetch", "tests/data/published/fetch.urdf", ""},
    {"anymal_c", "tests/data/published/anymal_c.urdf", ""},  // its base floats
    // Legs with loops, which take joints along: at most 1 % beyond a limit of speed.
    {"cassie", "tests/data/published/cassie_v4.urdf", "", 1.0, 3},
};

std::string path_of(const char* name) {
  return std::string(TREELINE_SOURCES) + "/" + name;
}

/// The scene's file; a proposed one is written.
std::string scene_file(const Tried& tried, Diagnostics& diagnostics) {
  if (*tried.scene != '\0') return path_of(tried.scene);
  const auto robot = read_urdf(path_of(tried.urdf), diagnostics);
  const SceneProposal proposal = propose_scene(*robot, std::nullopt);
  const std::string file = testing::TempDir() + tried.name + "_proposed.yaml";
  std::ofstream(file) << print_scene(*robot, proposal, tried.urdf, {});
  return file;
}

/// A robot that can be driven, and where it starts.
struct Ready {
  LaunchedRobot robot;
  std::vector<double> start;
};

std::optional<Ready> make_ready(const Tried& tried, Diagnostics& diagnostics) {
  InputOptions options;
  options.urdf = path_of(tried.urdf);
  options.scene = scene_file(tried, diagnostics);
  options.functions_from = FunctionsFrom::command;
  options.limits_for = LimitUse::drive;
  auto inputs = read_inputs(options, diagnostics);
  if (!inputs) return std::nullopt;
  const auto accepts = [](const drive::RobotDescription&) { return true; };
  const auto tell = [](const std::string&) {};
  auto robot = launch({std::move(inputs->robot),
                       std::move(inputs->scene),
                       inputs->files.urdf_text,
                       inputs->files.scene_text,
                       {}},
                      accepts, tell, diagnostics);
  if (!robot) return std::nullopt;
  auto start = start_of(*robot, {}, diagnostics);
  if (start.empty()) return std::nullopt;
  (void)free_weak_robot(robot->library.functions(), robot->description, start);
  return Ready{std::move(*robot), std::move(start)};
}

/// Lines as people type them, those of a hand again and again.
class Author {
 public:
  Author(const drive::RobotDescription& robot, unsigned seed) : robot_(robot), rng_(seed) {}

  std::vector<std::string> write() {
    lines_ = {"start", "wait 0.05 s"};
    const int count = 4 + below(7);
    for (int i = 0; i < count; ++i) {
      write_one();
      lines_.push_back(fmt::format("wait {:.3f} s", between(0.02, 1.5)));
    }
    lines_.emplace_back("wait 1.5 s");
    return lines_;
  }

 private:
  int below(int count) { return std::uniform_int_distribution<int>(0, count - 1)(rng_); }
  double between(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(rng_);
  }
  std::string three(double reach) {
    return fmt::format("{:.3f} {:.3f} {:.3f}", between(-reach, reach), between(-reach, reach),
                       between(-reach, reach));
  }
  std::string how_long() {
    if (below(2) == 0) return "";
    return fmt::format(" in {:.3f} s", std::exp(between(std::log(0.03), std::log(3.0))));
  }
  std::string joint() {
    for (;;) {
      const auto& one = robot_.coordinates[static_cast<std::size_t>(
          below(static_cast<int>(robot_.coordinates.size())))];
      if (is_single(one)) return one.name;
    }
  }
  std::string point() {
    return robot_.points[static_cast<std::size_t>(below(static_cast<int>(robot_.points.size())))]
        .name;
  }
  /// A lease, for some time.
  void keep(const std::string& line) {
    const int times = 3 + below(25);
    for (int i = 0; i < times; ++i) {
      lines_.push_back(line);
      lines_.emplace_back("wait 0.04 s");
    }
  }
  void write_one() {
    const int what = below(robot_.points.empty() ? 6 : 12);
    if (what < 6) {
      write_for_joints(what);
    } else {
      write_for_points(what - 6);
    }
  }
  void write_for_joints(int what) {
    if (what < 2) {
      lines_.push_back(fmt::format("joint {} {} {:.3f}{}", joint(), below(2) == 0 ? "to" : "by",
                                   between(-2, 2), how_long()));
    } else if (what == 2) {
      const auto mode = static_cast<std::size_t>(below(robot_.points.empty() ? 2 : 3));
      lines_.emplace_back(std::array{"mode joint", "mode gravity", "mode task"}[mode]);
    } else if (what == 3) {
      lines_.emplace_back(below(2) == 0 ? "hold" : "posture home");
    } else if (what == 4) {
      keep(fmt::format("drag joint {} to {:.3f}", joint(), between(-2, 2)));
    } else if (!robot_.links.empty()) {
      const int link = below(static_cast<int>(robot_.links.size()));
      keep(fmt::format("pull {} at {} to {}", robot_.links[static_cast<std::size_t>(link)],
                       three(0.1), three(1.0)));
    }
  }
  void write_for_points(int what) {
    const double reach = below(3) == 0 ? 1.5 : 0.3;
    if (what < 3) {
      const char* const how = below(4) == 0 ? "to" : "by";
      lines_.push_back(fmt::format("move {} {} {}{}", point(), how, three(reach), how_long()));
    } else if (what == 3) {
      lines_.push_back(fmt::format("turn {} by {}{}", point(), three(1.5), how_long()));
    } else if (what == 4) {
      lines_.push_back(fmt::format("posture {} by {:.3f}{}", joint(), between(-1, 1), how_long()));
    } else {
      keep(fmt::format("drag {} to {}", point(), three(1.0)));
    }
  }

  const drive::RobotDescription& robot_;
  std::mt19937 rng_;
  std::vector<std::string> lines_;
};

/// A robot that obeys a script in simulated time.
class Run {
 public:
  Run(const Ready& ready, double most)
      : ready_(ready),
        most_(most),
        loop_(ready.robot.library.functions(), ready.robot.description, setup_of(ready)),
        layout_(drive::report_layout(ready.robot.library.functions().coordinates,
                                     ready.robot.library.functions().velocities,
                                     ready.robot.library.functions().points)),
        numbers_(static_cast<std::size_t>(layout_.size)) {}

  /// What went wrong; empty: nothing.
  std::string run(const std::vector<std::string>& lines) {
    for (const std::string& line : lines) {
      const auto parsed = drive::parse_command(line, ready_.robot.description);
      const auto* command = std::get_if<drive::Command>(&parsed);
      if (command == nullptr) continue;  // refused, as a goal beyond a limit is
      if (command->verb != drive::Verb::wait) {
        if (!loop_.send(drive::message_for(*command))) return "a full mailbox";
        continue;
      }
      const double end = time_ + command->duration;
      while (time_ < end && fault_.empty()) step();
      if (!fault_.empty()) return fmt::format("after `{}` at {:.3f} s: {}", last_, time_, fault_);
      last_ = line;
    }
    return {};
  }
  double fastest() const { return fastest_; }

 private:
  static LoopSetup setup_of(const Ready& ready) {
    LoopSetup setup;
    setup.real_time = false;
    setup.start = ready.start;
    return setup;
  }
  void step() {
    loop_.step();
    drive::ReportHead head;
    loop_.receive(head, numbers_.data());
    time_ = head.time;
    if (head.fault_kind != 0) {
      fault_ = servo::describe({static_cast<servo::FaultKind>(head.fault_kind), head.fault_index,
                                head.fault_value, head.fault_limit});
      return;
    }
    for (const drive::DrivenCoordinate& each : ready_.robot.description.coordinates) {
      if (!is_single(each) || !std::isfinite(each.velocity)) continue;
      const double share =
          std::fabs(numbers_[static_cast<std::size_t>(layout_.qd + each.velocity_index)]) /
          each.velocity;
      fastest_ = std::max(fastest_, share);
      if (share > most_) fault_ = fmt::format("{} at {:.3f} of its speed", each.name, share);
    }
  }

  const Ready& ready_;
  double most_;
  LoopHandle loop_;
  drive::ReportLayout layout_;
  std::vector<double> numbers_;
  double time_ = 0;
  double fastest_ = 0;
  std::string fault_, last_;
};

class RandomScripts : public testing::TestWithParam<Tried> {};

/// Runs scripts with these seeds, of which `admitted` may end in a fault: those are printed.
void expect_within_limits(const Tried& tried, unsigned first, int count, int admitted) {
  Diagnostics diagnostics;
  const auto ready = make_ready(tried, diagnostics);
  ASSERT_TRUE(ready.has_value());
  int failed = 0;
  double fastest = 0;
  for (int i = 0; i < count; ++i) {
    const unsigned seed = first + static_cast<unsigned>(i);
    const auto lines = Author(ready->robot.description, seed).write();
    Run run(*ready, tried.most);
    const std::string wrong = run.run(lines);
    fastest = std::max(fastest, run.fastest());
    if (wrong.empty()) continue;
    const std::string report =
        fmt::format("{}, seed {}: {}\n{}", tried.name, seed, wrong, fmt::join(lines, "\n"));
    if (++failed <= admitted) {
      std::printf("%s\n", report.c_str());
    } else {
      ADD_FAILURE() << report;
    }
    if (failed > 3) break;
  }
  std::printf("%s: seeds %u to %u, at most %.3f of a limit of speed, %d failed\n", tried.name,
              first, first + static_cast<unsigned>(count) - 1, fastest, failed);
}

TEST_P(RandomScripts, StayWithinLimits) {
  expect_within_limits(GetParam(), 1, 15, 0);
}

TEST_P(RandomScripts, ByTheThousandStayWithinLimits) {
  expect_within_limits(GetParam(), 1000, 715, GetParam().faults);
}

INSTANTIATE_TEST_SUITE_P(Robots, RandomScripts, testing::ValuesIn(kTried),
                         [](const auto& robot) { return std::string(robot.param.name); });

}  // namespace
}  // namespace treeline
