#include <cmath>
#include <limits>
#include <sstream>
#include <vector>

#include "emission/descriptions.hpp"
#include "text/printable.hpp"

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

/// Writes a string of C, and of languages made from it.
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

/// Limits that are infinite by the name `unlimited`.
std::string print_limits(const std::vector<double>& limits, const Syntax& syntax,
                         const std::string& unlimited) {
  std::vector<std::string> entries;
  for (const double limit : limits) {
    if (!std::isfinite(limit)) {
      entries.push_back(limit < 0 ? std::string(syntax.sign(Op::neg)) + unlimited : unlimited);
    } else {
      entries.push_back(syntax.literal(limit));
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

}  // namespace

double largest_number(bool single_precision) {
  return single_precision ? static_cast<double>(std::numeric_limits<float>::max())
                          : std::numeric_limits<double>::max();
}

JointArrays describe_joints(const EmissionContext& context, const Syntax& syntax,
                            const std::string& unlimited) {
  std::vector<std::string> joints, meanings, movers, names;
  std::vector<double> home, lower, upper, velocity, effort;
  for (const EmissionContext::CoordinateRow& row : context.coordinate_rows) {
    joints.push_back(row.joint);
    meanings.push_back(row.meaning);
    home.push_back(row.home);
    lower.push_back(row.lower);
    upper.push_back(row.upper);
  }
  for (const EmissionContext::VelocityRow& row : context.velocity_rows) {
    movers.push_back(row.joint);
    names.push_back(row.name);
    velocity.push_back(row.velocity);
    effort.push_back(row.effort);
  }
  const auto print = [&](const std::vector<double>& limits) {
    return print_limits(limits, syntax, unlimited);
  };
  const std::vector<std::string> rows = name_task_rows(context);
  return {{{"robot", context.robot},
           {"name", context.name},
           {"real", number_type(context)},
           {"unlimited", syntax.literal(largest_number(context.single_precision))},
           {"nq", std::to_string(joints.size())},
           {"nv", std::to_string(names.size())},
           {"coordinate_joints", print_strings(joints)},
           {"coordinate_meanings", print_strings(meanings)},
           {"home", print(home)},
           {"lower_limits", print(lower)},
           {"upper_limits", print(upper)},
           {"velocity_joints", print_strings(movers)},
           {"velocity_names", print_strings(names)},
           {"velocity_limits", print(velocity)},
           {"effort_limits", print(effort)}},
          rows.size(),
          print_strings(rows)};
}

}  // namespace treeline
