#include "description/snap_angles.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <string_view>
#include <utility>

#include "description/for_each_pose.hpp"
#include "description/join_robots.hpp"
#include "description/noise.hpp"
#include "description/rotation.hpp"

namespace treeline {
namespace {

constexpr double kDust = 1e-12;
constexpr int kFewestDecimals = 4;

/// Digits behind the point of the shortest decimal that is this double: those that were written,
/// but for zeros at the end.
int count_decimals(double angle) {
  std::array<char, 512> text{};
  const auto end =
      std::to_chars(text.data(), text.data() + text.size(), angle, std::chars_format::fixed).ptr;
  const std::string_view written(text.data(), static_cast<std::size_t>(end - text.data()));
  const auto point = written.find('.');
  return point == std::string_view::npos ? 0 : static_cast<int>(written.size() - point) - 1;
}

/// An angle that is replaced, or would be.
struct Snap {
  std::string file;
  int line = 0;
  std::string element;
  double written = 0, multiple = 0;
  int times = 1;
};

void add_snap(const Snap& snap, std::vector<Snap>& snaps) {
  const auto same = std::find_if(snaps.begin(), snaps.end(), [&](const Snap& known) {
    return known.written == snap.written && known.file == snap.file;
  });
  if (same == snaps.end()) {
    snaps.push_back(snap);
  } else {
    ++same->times;
  }
}

void report_snapped(const std::vector<Snap>& snaps, double tolerance, Diagnostics& diagnostics) {
  for (const Snap& snap : snaps) {
    const std::string more = snap.times > 1 ? fmt::format(" (and {} more)", snap.times - 1) : "";
    diagnostics.add(
        {Severity::note, snap.file, snap.line, snap.element,
         fmt::format("the angle {} is taken as {}, {:.1e} rad off{}", snap.written,
                     name_quarter_turns(snap.multiple), std::abs(snap.written - snap.multiple),
                     more),
         fmt::format("Because of `snap_angles: {}`; leave it out for the angle as it is.",
                     tolerance)});
  }
}

void suggest_snapping(const std::vector<Snap>& snaps, Diagnostics& diagnostics) {
  if (snaps.empty()) return;
  int angles = 0;
  double farthest = 0;
  for (const Snap& snap : snaps) {
    angles += snap.times;
    farthest = std::max(farthest, std::abs(snap.written - snap.multiple));
  }
  // One digit, rounded up.
  const double decade = std::pow(10, std::floor(std::log10(farthest)));
  const double enough = std::min(kWidestSnap, std::ceil(farthest / decade * 1.01) * decade);
  const Snap& first = snaps.front();
  diagnostics.add(
      {Severity::note, first.file, first.line, first.element,
       fmt::format("{} angles are quarter turns but for rounding, as here {} for {}; they are "
                   "used as they are written",
                   angles, first.written, name_quarter_turns(first.multiple)),
       fmt::format(
           "`snap_angles: {:.0e}` in the scene takes them as exact, which saves operations.",
           enough)});
}

}  // namespace

std::optional<double> rounded_quarter_turns(double angle, double tolerance) {
  const QuarterTurns nearest = nearest_quarter_turns(angle);
  const double multiple = nearest.as_double;
  const double off = std::abs(nearest.off);
  const bool exact = angle == multiple || (nearest.turns != 0 && off <= kResolution);
  if (exact || off > tolerance) return std::nullopt;
  if (off <= kDust) return multiple;
  const int decimals = count_decimals(angle);
  if (nearest.turns == 0 || decimals < kFewestDecimals) return std::nullopt;
  const double unit = std::pow(10, -decimals);
  const double rounding = 4e-16 * std::abs(angle);
  const bool cut_off = std::abs(angle) < std::abs(multiple);
  const bool written_so = off <= (cut_off ? unit : unit / 2) + rounding;
  return written_so ? std::optional(multiple) : std::nullopt;
}

std::string name_quarter_turns(double angle) {
  const int turns = static_cast<int>(nearest_quarter_turns(angle).turns);
  if (turns == 0) return "0";
  const bool whole = turns % 2 == 0;
  const int over = std::abs(whole ? turns / 2 : turns);
  return fmt::format("{}{}pi{}", turns < 0 ? "-" : "", over == 1 ? "" : fmt::format("{} ", over),
                     whole ? "" : "/2");
}

Robot with_snapped_angles(Robot robot, double tolerance) {
  for_each_pose(robot, [&](Pose& pose, const std::string&, const std::string&) {
    for (double& angle : pose.rpy) angle = rounded_quarter_turns(angle, tolerance).value_or(angle);
  });
  return robot;
}

void snap_angles(const Robot& robot, Scene& scene, Diagnostics& diagnostics) {
  const bool asked_for = scene.snap_angles > 0;
  const double tolerance = asked_for ? scene.snap_angles : kWidestSnap;
  std::vector<Snap> snaps;
  const auto note = [&](const std::string& file, int line, const std::string& element,
                        double angle) {
    const auto multiple = rounded_quarter_turns(angle, tolerance);
    const bool is_noise = multiple && std::abs(angle - *multiple) <= scene.noise;
    if (multiple && (asked_for || !is_noise))
      add_snap({file, line, element, angle, *multiple}, snaps);
    return multiple.value_or(angle);
  };
  for_each_pose(robot, [&](const Pose& pose, const std::string& owner, const std::string& element) {
    for (const double angle : pose.rpy) note(file_of(robot, owner), pose.line, element, angle);
  });
  for_each_point_pose(scene, [&](Pose& pose, const std::string& element) {
    for (double& angle : pose.rpy) {
      const double taken = note(scene.file, pose.line, element, angle);
      if (asked_for) angle = taken;
    }
  });
  if (asked_for) {
    report_snapped(snaps, tolerance, diagnostics);
  } else {
    suggest_snapping(snaps, diagnostics);
  }
}

}  // namespace treeline
