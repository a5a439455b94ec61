#pragma once
// Random scripts of `treeline drive`.

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <random>
#include <string>
#include <vector>

#include "drive/robot_description.hpp"

namespace treeline::test {

/// Lines as people type them, those of a hand again and again.
class ScriptAuthor {
 public:
  ScriptAuthor(const drive::RobotDescription& robot, unsigned seed) : robot_(robot), rng_(seed) {}

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

}  // namespace treeline::test
