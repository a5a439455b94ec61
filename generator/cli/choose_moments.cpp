#include "cli/choose_moments.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "drawing/recorded_motion.hpp"
#include "drawing/scene_solids.hpp"
#include "terminal/option_values.hpp"
#include "text/suggest_name.hpp"

namespace treeline {
namespace {

constexpr std::size_t kMostMoments = 1000;

/// Index of each operational point or link whose path is drawn, links behind points; nothing, with
/// an error, if there is none of a name.
std::optional<std::vector<std::size_t>> find_traced(const DrawnRobot& drawn,
                                                    const std::vector<std::string>& wanted,
                                                    Diagnostics& diagnostics) {
  std::vector<std::string> names;
  for (const ScenePoint& point : drawn.scene.operational_points) names.push_back(point.name);
  for (const Link& link : drawn.robot.links) names.push_back(link.name);
  std::vector<std::size_t> traced;
  for (const std::string& name : wanted) {
    const auto found = std::ranges::find(names, name);
    traced.push_back(static_cast<std::size_t>(found - names.begin()));
    if (found != names.end()) continue;
    diagnostics.add({Severity::error, drawn.scene.file, 0, "--path",
                     fmt::format("there is no operational point or link `{}`", name),
                     suggest_name(name, names)});
    return std::nullopt;
  }
  return traced;
}

/// The row of a motion that is nearest before a time, or at it.
std::size_t row_at(const RecordedMotion& motion, double time) {
  constexpr double kSlack = 1e-9;  // s, of times that were rounded in the file
  const auto after = std::upper_bound(motion.times.begin(), motion.times.end(), time + kSlack);
  return static_cast<std::size_t>(std::max<std::ptrdiff_t>(0, after - motion.times.begin() - 1));
}

/// Whether the motion has these times, to the digits that are shown; else with an error.
bool are_within(const std::vector<double>& times, const RecordedMotion& motion,
                const std::string& file, Diagnostics& diagnostics) {
  const double first = motion.times.front();
  const double last = motion.times.back();
  const double slack = 1e-3 * (last - first);
  const auto beyond = std::find_if(times.begin(), times.end(), [&](double time) {
    return time < first - slack || time > last + slack;
  });
  if (beyond == times.end()) return true;
  diagnostics.add({Severity::error, file, 0, "--times",
                   fmt::format("{:g} s is not in the motion, which goes from {:g} to {:g} s",
                               *beyond, first, last),
                   "give times within it"});
  return false;
}

std::vector<double> evenly_spread(double first, double last, std::size_t count) {
  if (count == 1) return {last};
  std::vector<double> times;
  for (std::size_t i = 0; i < count; ++i) {
    times.push_back(first +
                    (last - first) * static_cast<double>(i) / static_cast<double>(count - 1));
  }
  return times;
}

/// Moments of an animation of these seconds, with an error if they are too many.
std::optional<std::size_t> count_moments(double seconds, double rate, Diagnostics& diagnostics) {
  const double steps = std::max(1.0, std::round(seconds * rate));
  if (steps < kMostMoments) return static_cast<std::size_t>(steps) + 1;
  diagnostics.add({Severity::error, "", 0, "--animate",
                   fmt::format("{:.0f} pictures are too many for one file", steps),
                   "play it in fewer --seconds, or choose a part by --times FIRST,LAST"});
  return std::nullopt;
}

/// The times of the pictures: as asked for, or evenly spread.
std::optional<std::vector<double>> choose_times(const MomentOptions& options,
                                                const RecordedMotion& motion,
                                                Diagnostics& diagnostics) {
  const bool given = !options.times.empty();
  if (!are_within(options.times, motion, options.motion, diagnostics)) return std::nullopt;
  if (given && !options.animate) return options.times;
  const double first = given ? options.times.front() : motion.times.front();
  const double last = given ? options.times.back() : motion.times.back();
  if (!options.animate) {
    return evenly_spread(first, last, static_cast<std::size_t>(options.pictures));
  }
  const double seconds = options.seconds > 0 ? options.seconds : last - first;
  const auto count = count_moments(seconds, options.film.rate, diagnostics);
  if (!count) return std::nullopt;
  return evenly_spread(first, last, *count);
}

/// From one state to another and back, slowly at both.
std::optional<RecordedMotion> move_there_and_back(const MomentOptions& options,
                                                  const std::vector<double>& home,
                                                  Diagnostics& diagnostics) {
  constexpr double kSeconds = 4;
  const int size = static_cast<int>(home.size());
  if (!has_size("--q", options.q, size, diagnostics)) return std::nullopt;
  if (!has_size("--to", options.to, size, diagnostics)) return std::nullopt;
  const std::vector<double>& from = options.q.empty() ? home : options.q;
  RecordedMotion motion;
  motion.times = evenly_spread(0, options.seconds > 0 ? options.seconds : kSeconds, kMostMoments);
  for (const double time : motion.times) {
    const double share = 0.5 - 0.5 * std::cos(2 * std::numbers::pi * time / motion.times.back());
    std::vector<double> q = from;
    for (std::size_t i = 0; i < q.size(); ++i) q[i] += share * (options.to[i] - from[i]);
    motion.q.push_back(std::move(q));
  }
  return motion;
}

/// Path of a point or a link up to a row, in at most some hundred steps.
std::vector<Eigen::Vector3d> trace_path(const LinkPlacer& placer, const RecordedMotion& motion,
                                        std::size_t traced, std::size_t row) {
  constexpr std::size_t kSteps = 120;
  const std::size_t stride = std::max<std::size_t>(1, motion.times.size() / kSteps);
  const auto place = [&](std::size_t k) -> Eigen::Vector3d {
    const auto points = placer.place_points(motion.q[k]);
    if (traced < points.size()) return points[traced].translation();
    return placer.place(motion.q[k])[traced - points.size()].translation();
  };
  std::vector<Eigen::Vector3d> path;
  for (std::size_t k = 0; k < row; k += stride) path.push_back(place(k));
  path.push_back(place(row));
  return path;
}

std::optional<std::vector<Moment>> choose_unladen(const MomentOptions& options,
                                                  const DrawnRobot& drawn, const LinkPlacer& placer,
                                                  Diagnostics& diagnostics) {
  if (options.motion.empty() && options.to.empty()) {
    if (!has_size("--q", options.q, placer.coordinates(), diagnostics)) return std::nullopt;
    return std::vector<Moment>{
        {options.q.empty() ? placer.home() : options.q, drawn.robot.name, {}, {}}};
  }
  const auto motion =
      options.motion.empty()
          ? move_there_and_back(options, placer.home(), diagnostics)
          : read_motion(options.motion, placer.joints(), placer.home(), diagnostics);
  const auto traced = motion ? find_traced(drawn, options.paths, diagnostics) : std::nullopt;
  const auto times = traced ? choose_times(options, *motion, diagnostics) : std::nullopt;
  if (!times) return std::nullopt;
  std::vector<Moment> moments;
  for (const double time : *times) {
    const std::size_t row = row_at(*motion, time);
    const auto caption =
        options.animate ? fmt::format("{:.1f} s", time) : fmt::format("{:.4g} s", time);
    moments.push_back({motion->q[row], caption, {}, {}});
    for (const std::size_t index : *traced) {
      moments.back().paths.push_back(trace_path(placer, *motion, index, row));
    }
  }
  return moments;
}

}  // namespace

std::optional<std::vector<Moment>> choose_moments(const MomentOptions& options,
                                                  const DrawnRobot& drawn, const LinkPlacer& placer,
                                                  Diagnostics& diagnostics) {
  auto moments = choose_unladen(options, drawn, placer, diagnostics);
  if (!moments) return std::nullopt;
  for (Moment& moment : *moments) {
    moment.held = object_solids(drawn.scene.objects, drawn.surroundings.shapes,
                                drawn.scene.operational_points, placer.place_points(moment.q));
  }
  return moments;
}

}  // namespace treeline
