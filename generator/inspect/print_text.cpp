#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "inspect/inspect_robot.hpp"
#include "inspect/print_tables.hpp"
#include "text/align_columns.hpp"
#include "text/printable.hpp"

namespace treeline {
namespace {

using Rows = std::vector<std::vector<std::string>>;

constexpr std::size_t kMostNamed = 6;
constexpr int kDeepestIndented = 24;

std::string number(double value, int digits = 5) {
  if (std::isinf(value)) return value < 0 ? "-inf" : "inf";
  return fmt::format("{:.{}g}", value, digits);
}

std::string bound(double value) {
  return std::isinf(value) ? "none" : number(value);
}

template <class Values>
std::string numbers(const Values& values, int digits = 5) {
  std::string text;
  for (const double value : values) {
    text += text.empty() ? "" : " ";
    text += number(value, digits);
  }
  return text;
}

/// Lists the first few names, and the number of the others.
std::string name_some(const std::vector<std::string>& names) {
  const std::size_t named = std::min(names.size(), kMostNamed);
  const std::string text = fmt::format(
      "{}", fmt::join(names.begin(), names.begin() + static_cast<std::ptrdiff_t>(named), ", "));
  return named == names.size() ? text : fmt::format("{} and {} more", text, names.size() - named);
}

std::string section(const std::string& title, const std::vector<Column>& columns,
                    const Rows& rows) {
  if (rows.empty()) return {};
  return fmt::format("\n{}\n{}", title, align_columns(columns, rows, page_columns()));
}

std::string summarise_mass_matrix(const Report& report) {
  if (!report.mass_matrix) return "none: nothing moves";
  const MassMatrixReport& M = *report.mass_matrix;
  return std::isinf(M.condition) ? "singular: forward dynamics and lambda are not defined"
                                 : fmt::format("condition {}, scaled to a unit diagonal {}",
                                               number(M.condition), number(M.scaled_condition));
}

std::string summarise_inertias(const Report& report) {
  std::vector<std::string> unphysical;
  for (const LinkReport& link : report.links) {
    if (link.unphysical) unphysical.push_back(link.name);
  }
  return unphysical.empty() ? "all physical"
                            : fmt::format("{} that no body can have: {}", unphysical.size(),
                                          name_some(unphysical));
}

std::string summarise_risks(const Report& report) {
  std::map<std::string, std::vector<std::string>> joints;
  for (const RiskReport& risk : report.risks) {
    joints[risk.kind].push_back(risk.joint.empty() ? "all joints" : risk.joint);
  }
  std::string text;
  for (const auto& [kind, names] : joints) {
    text += fmt::format("{}{} ({})", text.empty() ? "" : "; ", kind, name_some(names));
  }
  return text.empty() ? "none found" : text + "; see the end";
}

std::string summarise_loops(const LoopsReport& loops) {
  std::string text = fmt::format("{} {}", loops.rows, loops.rows == 1 ? "row" : "rows");
  if (loops.dependent > 0) text += fmt::format(", {} implied by the others", loops.dependent);
  text += fmt::format("; {} {} of the joints in them", loops.freedoms,
                      loops.freedoms == 1 ? "freedom" : "freedoms");
  if (loops.unheld > 0) text += fmt::format(", {} not held by motors", loops.unheld);
  return text;
}

std::string print_tree(const Report& report) {
  int deepest = 0;
  for (const LinkReport& link : report.links) deepest = std::max(deepest, link.depth);
  const int step = 2 * deepest <= kDeepestIndented ? 2 : 1;
  Rows rows;
  for (const LinkReport& link : report.links) {
    const int indent = std::min(step * link.depth, kDeepestIndented);
    const std::string level = step * link.depth > indent ? fmt::format("({}) ", link.depth) : "";
    rows.push_back({std::string(static_cast<std::size_t>(indent), ' ') + level + link.name,
                    link.joint, link.motion, link.lumped_with});
  }
  return section("tree", {{"link"}, {"joint"}, {"motion"}, {"part of"}}, rows);
}

std::string print_inertials(const Report& report) {
  Rows rows;
  for (const LinkReport& link : report.links) {
    if (!link.has_inertial) continue;
    rows.push_back({link.name, number(link.mass), numbers(link.com, 4), numbers(link.moments, 4),
                    link.unphysical ? "not physical" : ""});
  }
  return section(
      "masses",
      {{"link"}, {"kg", true}, {"centre of mass, m"}, {"principal moments, kg m^2"}, {""}}, rows);
}

std::string range(int first, int count) {
  return count == 1 ? fmt::format("{}", first) : fmt::format("{}..{}", first, first + count - 1);
}

std::string with_unit(double value, const std::string& unit) {
  return unit.empty() || std::isinf(value) ? bound(value) : number(value) + " " + unit;
}

std::string print_joints(const Report& report) {
  Rows rows;
  for (const JointReport& joint : report.joints) {
    const bool single = !joint.unit.empty();
    rows.push_back({range(joint.q, joint.nq), range(joint.v, joint.nv), joint.name, joint.type,
                    single ? bound(joint.lower) : "", single ? bound(joint.upper) : "", joint.unit,
                    with_unit(joint.velocity, single ? joint.unit + "/s" : ""),
                    with_unit(joint.effort, joint.unit == "m" ? "N"
                                            : single          ? "N m"
                                                              : ""),
                    joint.follows.empty() ? "" : "= " + joint.follows});
  }
  return section("joints, in the order of q",
                 {{"q", true},
                  {"qd", true},
                  {"joint"},
                  {"type"},
                  {"lower", true},
                  {"upper", true},
                  {""},
                  {"velocity", true},
                  {"effort", true},
                  {"mimics"}},
                 rows);
}

std::string print_drives(const Report& report) {
  const auto shown = [](double value) { return value > 0 ? number(value) : ""; };
  Rows rows;
  for (const JointReport& joint : report.joints) {
    if (!joint.drive) continue;
    const DriveReport& own = *joint.drive;
    rows.push_back({joint.name, shown(own.rotor), shown(own.damping), shown(own.friction),
                    shown(own.width), shown(own.stiffness),
                    own.stiffness > 0 ? number(own.rest) : ""});
  }
  if (rows.empty()) return {};
  return section("rotors, friction and springs (SI units)",
                 {{"joint"},
                  {"rotor", true},
                  {"damping", true},
                  {"friction", true},
                  {"within", true},
                  {"stiffness", true},
                  {"rest", true}},
                 rows);
}

std::string print_points(const std::string& title, const std::vector<PointReport>& points) {
  Rows rows;
  for (const PointReport& point : points) {
    rows.push_back({point.name, point.link, point.axes, point.rows});
  }
  return section(title, {{"name"}, {"link"}, {"axes"}, {"rows"}}, rows);
}

std::string print_reductions(const Report& report) {
  Rows rows;
  for (const ReductionReport& link : report.reductions) {
    rows.push_back({link.link, number(link.mass_before), number(link.mass_after),
                    fmt::format("{}", link.numbers_before), fmt::format("{}", link.numbers_after)});
  }
  std::string text = section(
      "moving links before and after regrouping",
      {{"link"}, {"kg", true}, {"kg after", true}, {"inertial numbers", true}, {"after", true}},
      rows);
  Rows notes;
  for (const NoteReport& note : report.notes) notes.push_back({note.step, note.link, note.text});
  return text + section("what was reduced", {{"step"}, {"link"}, {""}}, notes);
}

std::string print_mass_matrix(const Report& report) {
  if (!report.mass_matrix) return "\nnothing moves\n";
  const MassMatrixReport& M = *report.mass_matrix;
  std::string text = "\nmass matrix, all coordinates at 0 (SI units)\n";
  text += wrap_labelled("  diagonal     ", numbers(M.diagonal), page_columns());
  text += fmt::format("  eigenvalues  {} to {}\n", number(M.least), number(M.largest));
  text += fmt::format("  condition    {}, scaled to a unit diagonal {}\n", number(M.condition),
                      number(M.scaled_condition));
  if (std::isinf(M.condition)) text += "  singular: forward dynamics and lambda are not defined\n";
  return text;
}

std::string print_risks(const Report& report) {
  Rows rows;
  std::string advice;
  for (const RiskReport& risk : report.risks) {
    rows.push_back({risk.joint.empty() ? "all" : risk.joint, risk.kind,
                    fmt::format("{:.1f}", risk.digits_lost), risk.finding});
    const std::string line =
        wrap_labelled(fmt::format("  {}: ", risk.kind), risk.advice, page_columns());
    if (advice.find(line) == std::string::npos) advice += line;
  }
  return section("risky joints: digits that may get lost, of 15.7",
                 {{"joint"}, {"by"}, {"digits", true}, {""}}, rows) +
         advice;
}

}  // namespace

std::string print_summary(const Report& report) {
  const auto line = [](const char* label, const std::string& text) {
    return wrap_labelled(fmt::format("  {:<8} ", label), text, page_columns());
  };
  std::string text = wrap_labelled(
      "", fmt::format("{} ({})", printable(report.robot), printable(report.urdf)), page_columns());
  if (!report.scene.empty()) text += line("scene", report.scene);
  text += line("base", fmt::format("{}, gravity {} m/s^2", report.base, numbers(report.gravity)));
  text +=
      line("size", fmt::format("{} links, {} moving joints, {} coordinates, {} velocities",
                               report.links.size(), report.joints.size(), report.nq, report.nv));
  text += line("mass", fmt::format("{} kg, of which {} kg move", number(report.mass),
                                   number(report.moving_mass)));
  text += line("centre", numbers(report.com) + " m in the root's frame, all coordinates at 0");
  text += line("inertias", summarise_inertias(report));
  text += line("M", summarise_mass_matrix(report));
  if (report.loops) text += line("loops", summarise_loops(*report.loops));
  return text + line("risks", summarise_risks(report));
}

std::string print_text(const Report& report) {
  std::string text = print_summary(report);
  text += print_tree(report);
  text += print_joints(report);
  text += print_drives(report);
  text += print_inertials(report);
  text += print_points("operational points", report.operational_points);
  text += print_points("external forces", report.external_forces);
  text += print_inertias(report);
  text += print_reductions(report);
  text += print_mass_matrix(report);
  text += print_risks(report);
  return text;
}

}  // namespace treeline
