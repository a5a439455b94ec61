#include <fmt/format.h>

#include <algorithm>

#include "comparison/difference.hpp"
#include "text/align_columns.hpp"
#include "text/printable.hpp"

namespace treeline {
namespace {

using Rows = std::vector<std::vector<std::string>>;

std::string number(double value) {
  return fmt::format("{:.3g}", value);
}

/// Prints the value, or nothing if it is within the tolerance.
std::string beyond(double value, double tolerance) {
  return value > tolerance ? number(value) : "";
}

std::string renamed(const std::string& first, const std::string& second) {
  return first == second ? "" : second;
}

template <class Items>
std::size_t count_renamed(const Items& items) {
  return static_cast<std::size_t>(std::count_if(
      items.begin(), items.end(), [](const auto& item) { return item.first != item.second; }));
}

std::string count_line(const char* what, std::size_t both, std::size_t renamed, std::size_t first,
                       std::size_t second) {
  return fmt::format(
      "  {:<9} {} in both, {} of them renamed; {} in the first only, {} in the second\n", what,
      both, renamed, first, second);
}

template <class Value>
std::string worst_pose(const RobotDifference& difference, Value value, const char* unit) {
  const auto worst = std::max_element(
      difference.links.begin(), difference.links.end(),
      [&](const LinkDifference& a, const LinkDifference& b) { return a.*value < b.*value; });
  return fmt::format("{} {} ({})", number((*worst).*value), unit, worst->first);
}

std::string print_poses(const RobotDifference& difference) {
  if (difference.links.empty()) return "  poses     no link is in both\n";
  return fmt::format("  poses     up to {} and {}, seen from {}, {} random states\n",
                     worst_pose(difference, &LinkDifference::position, "m"),
                     worst_pose(difference, &LinkDifference::rotation, "rad"), difference.reference,
                     difference.states);
}

std::string print_deviation(const char* what, const Deviation& deviation) {
  std::string text = fmt::format("{} {}", what, number(deviation.relative));
  if (deviation.absolute > 0) {
    text +=
        fmt::format(" ({} {} at {})", number(deviation.absolute), deviation.unit, deviation.joint);
  }
  return text;
}

std::string print_dynamics(const RobotDifference& difference) {
  const DynamicsDifference& dynamics = difference.dynamics;
  const char* base = difference.base == Base::floating ? "floating" : "fixed";
  if (dynamics.coordinates == 0) {
    return fmt::format("  dynamics  not compared: with a {} base no coordinate is in both\n", base);
  }
  std::string text =
      fmt::format("  dynamics  {} base, {} coordinates in both; relative to the scale:\n", base,
                  dynamics.coordinates);
  text += fmt::format("            mass matrix {}", number(dynamics.mass_matrix));
  if (dynamics.mass_matrix > 0) text += fmt::format(" ({}, {})", dynamics.row, dynamics.column);
  text += "\n            " + print_deviation("gravity", dynamics.gravity);
  text += "\n            " + print_deviation("inverse dynamics", dynamics.inverse_dynamics) + "\n";
  return text;
}

std::string print_links(const RobotDifference& difference) {
  const double tolerance = difference.tolerance;
  Rows rows;
  for (const LinkDifference& link : difference.links) {
    if (!difference.differs(link)) continue;
    const bool masses = link.mass > tolerance;
    rows.push_back({link.first, renamed(link.first, link.second), beyond(link.position, tolerance),
                    beyond(link.rotation, tolerance),
                    masses ? fmt::format("{} and {}", link.first_mass, link.second_mass) : "",
                    beyond(link.centre, tolerance), beyond(link.inertia, tolerance)});
  }
  if (rows.empty()) return {};
  return "\nlinks that differ\n" + align_columns({{"link"},
                                                  {"in the second"},
                                                  {"pose, m", true},
                                                  {"rad", true},
                                                  {"mass, kg"},
                                                  {"centre, m", true},
                                                  {"inertia, relative", true}},
                                                 rows);
}

std::string print_joints(const RobotDifference& difference) {
  Rows rows;
  for (const JointDifference& joint : difference.joints) {
    if (!difference.differs(joint)) continue;
    rows.push_back({joint.first, renamed(joint.first, joint.second),
                    fmt::format("{}", fmt::join(joint.faults, "; "))});
  }
  if (rows.empty()) return {};
  return "\njoints that differ\n" +
         align_columns({{"joint"}, {"in the second"}, {"first and second"}}, rows);
}

std::string print_names(const char* title, const std::vector<std::string>& names) {
  if (names.empty()) return {};
  return fmt::format("\n{}\n  {}\n", title, fmt::join(names, "\n  "));
}

}  // namespace

std::string print_text(const RobotDifference& d) {
  std::string text =
      fmt::format("{} ({}) and {} ({}): {}, tolerance {}\n", printable(d.first_file),
                  printable(d.first_name), printable(d.second_file), printable(d.second_name),
                  d.differs() ? "different" : "the same", d.tolerance);
  text += count_line("links", d.links.size(), count_renamed(d.links), d.links_only_in_first.size(),
                     d.links_only_in_second.size());
  text += count_line("joints", d.joints.size(), count_renamed(d.joints),
                     d.joints_only_in_first.size(), d.joints_only_in_second.size());
  text += print_poses(d);
  text += fmt::format("  mass      {:.9g} kg and {:.9g} kg\n", d.first_mass, d.second_mass);
  text += print_dynamics(d);
  text += print_links(d);
  text += print_joints(d);
  text += print_names("links of the first only", d.links_only_in_first);
  text += print_names("links of the second only", d.links_only_in_second);
  text += print_names("joints of the first only", d.joints_only_in_first);
  text += print_names("joints of the second only", d.joints_only_in_second);
  return text;
}

}  // namespace treeline
