#include "emission/print_joints.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <sstream>
#include <vector>

#include "description/printable.hpp"
#include "emission/fill_template.hpp"
#include "emission/templates.hpp"
#include "program/format_literal.hpp"

namespace treeline {
namespace {

/// Entries with commas between, in lines of at most 100 columns, indented by four.
std::string print_entries(const std::vector<std::string>& entries) {
  constexpr std::size_t kMost = 94;
  std::string text;
  std::size_t column = 0;
  for (const std::string& entry : entries) {
    if (column > 0) {
      const bool fits = column + 2 + entry.size() <= kMost;
      text += fits ? ", " : ",\n    ";
      column = fits ? column + 2 : 0;
    }
    text += entry;
    column += entry.size();
  }
  return text;
}

/// As a string of C++.
std::string quote(const std::string& text) {
  std::string quoted = "\"";
  for (const char c : printable(text)) {
    if (c == '"' || c == '\\') quoted += '\\';
    quoted += c;
  }
  return quoted + '"';
}

std::string print_strings(std::vector<std::string> texts) {
  for (std::string& text : texts) text = quote(text);
  return print_entries(texts);
}

/// Limits that are infinite as `kUnlimited`.
std::string print_limits(const std::vector<double>& limits, bool single_precision) {
  std::vector<std::string> entries;
  for (const double limit : limits) {
    if (!std::isfinite(limit)) {
      entries.emplace_back(limit < 0 ? "-kUnlimited" : "kUnlimited");
    } else {
      entries.push_back(single_precision ? format_literal(static_cast<float>(limit))
                                         : format_literal(limit));
    }
  }
  return print_entries(entries);
}

/// The rows of all operational points, one after the other: "tool rx".
std::vector<std::string> name_task_rows(const EmissionContext& context) {
  std::vector<std::string> names;
  for (const EmissionContext::PointRow& point : context.operational_points) {
    std::istringstream rows(point.rows);
    for (std::string row; rows >> row;) names.push_back(point.name + " " + row);
  }
  return names;
}

std::string print_task_rows(const EmissionContext& context) {
  const std::vector<std::string> names = name_task_rows(context);
  if (names.empty()) return {};
  return fmt::format(
      "\n/// Of each task row: its point, and along or about which axis it is.\n"
      "inline constexpr const char* kTaskRowNames[{}] = {{\n    {}}};",
      names.size(), print_strings(names));
}

}  // namespace

std::string print_joints(const EmissionContext& context) {
  const bool single = context.single_precision;
  std::vector<std::string> joints, meanings, names;
  std::vector<double> lower, upper, velocity, effort;
  for (const EmissionContext::CoordinateRow& row : context.coordinate_rows) {
    joints.push_back(row.joint);
    meanings.push_back(row.meaning);
    lower.push_back(row.lower);
    upper.push_back(row.upper);
  }
  for (const EmissionContext::VelocityRow& row : context.velocity_rows) {
    names.push_back(row.name);
    velocity.push_back(row.velocity);
    effort.push_back(row.effort);
  }
  return fill_template(templates::kJoints,
                       {{"robot", context.robot},
                        {"name", context.name},
                        {"real", single ? "float" : "double"},
                        {"unlimited", single ? format_literal(std::numeric_limits<float>::max())
                                             : format_literal(std::numeric_limits<double>::max())},
                        {"nq", std::to_string(joints.size())},
                        {"nv", std::to_string(names.size())},
                        {"coordinate_joints", print_strings(joints)},
                        {"coordinate_meanings", print_strings(meanings)},
                        {"lower_limits", print_limits(lower, single)},
                        {"upper_limits", print_limits(upper, single)},
                        {"velocity_names", print_strings(names)},
                        {"velocity_limits", print_limits(velocity, single)},
                        {"effort_limits", print_limits(effort, single)},
                        {"task_rows", print_task_rows(context)}});
}

}  // namespace treeline
