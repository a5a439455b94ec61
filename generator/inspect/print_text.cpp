#include <fmt/format.h>

#include <cmath>

#include "inspect/align_columns.hpp"
#include "inspect/inspect_robot.hpp"

namespace treeline {
namespace {

using Rows = std::vector<std::vector<std::string>>;

std::string number(double value) {
  if (std::isinf(value)) return value < 0 ? "-inf" : "inf";
  return fmt::format("{:.5g}", value);
}

std::string bound(double value) {
  return std::isinf(value) ? "none" : number(value);
}

template <class Values>
std::string numbers(const Values& values) {
  std::string text;
  for (const double value : values) {
    text += text.empty() ? "" : " ";
    text += number(value);
  }
  return text;
}

std::string section(const std::string& title, const std::vector<Column>& columns,
                    const Rows& rows) {
  if (rows.empty()) return {};
  return fmt::format("\n{}\n{}", title, align_columns(columns, rows));
}

std::string print_head(const Report& report) {
  std::string text = fmt::format("{} ({})\n", report.robot, report.urdf);
  if (!report.scene.empty()) text += fmt::format("  scene    {}\n", report.scene);
  text += fmt::format("  base     {}, gravity {} m/s^2\n", report.base, numbers(report.gravity));
  text += fmt::format("  size     {} links, {} moving joints, {} coordinates, {} velocities\n",
                      report.links.size(), report.joints.size(), report.nq, report.nv);
  text += fmt::format("  mass     {} kg, of which {} kg move\n", number(report.mass),
                      number(report.moving_mass));
  text += fmt::format("  centre   {} m in the root's frame, all coordinates at 0\n",
                      numbers(report.com));
  return text;
}

std::string print_tree(const Report& report) {
  Rows rows;
  for (const LinkReport& link : report.links) {
    const std::string indent(2 * static_cast<std::size_t>(link.depth), ' ');
    rows.push_back(
        {indent + link.name, link.joint, link.motion, link.has_inertial ? number(link.mass) : "",
         link.has_inertial ? numbers(link.com) : "", link.has_inertial ? numbers(link.moments) : "",
         link.lumped_with, link.unphysical ? "not physical" : ""});
  }
  return section("tree",
                 {{"link"},
                  {"joint"},
                  {"motion"},
                  {"kg", true},
                  {"centre of mass, m"},
                  {"principal moments, kg m^2"},
                  {"part of"},
                  {""}},
                 rows);
}

std::string range(int first, int count) {
  return count == 1 ? fmt::format("{}", first) : fmt::format("{}..{}", first, first + count - 1);
}

std::string print_joints(const Report& report) {
  Rows rows;
  for (const JointReport& joint : report.joints) {
    const bool prismatic = joint.unit == "m";
    const bool single = !joint.unit.empty();
    rows.push_back({range(joint.q, joint.nq), range(joint.v, joint.nv), joint.name, joint.type,
                    single ? bound(joint.lower) : "", single ? bound(joint.upper) : "", joint.unit,
                    bound(joint.velocity), single ? joint.unit + "/s" : "", bound(joint.effort),
                    prismatic ? "N"
                    : single  ? "N m"
                              : "",
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
                  {""},
                  {"effort", true},
                  {""},
                  {"mimics"}},
                 rows);
}

std::string print_points(const std::string& title, const std::vector<PointReport>& points) {
  Rows rows;
  for (const PointReport& point : points) {
    rows.push_back({point.name, point.link, point.axes, point.rows});
  }
  return section(title, {{"name"}, {"link"}, {"axes"}, {"rows"}}, rows);
}

std::string print_unphysical(const Report& report) {
  Rows rows;
  for (const LinkReport& link : report.links) {
    if (link.unphysical) rows.push_back({link.name, *link.unphysical});
  }
  return section("inertias that are not physical", {{"link"}, {"why"}}, rows);
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
  text += fmt::format("  diagonal     {}\n", numbers(M.diagonal));
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
    const std::string line = fmt::format("  {}: {}\n", risk.kind, risk.advice);
    if (advice.find(line) == std::string::npos) advice += line;
  }
  return section("risky joints: digits that may get lost, of 15.7",
                 {{"joint"}, {"by"}, {"digits", true}, {""}}, rows) +
         advice;
}

}  // namespace

std::string print_text(const Report& report) {
  std::string text = print_head(report);
  text += print_tree(report);
  text += print_joints(report);
  text += print_points("operational points", report.operational_points);
  text += print_points("external forces", report.external_forces);
  text += print_unphysical(report);
  text += print_reductions(report);
  text += print_mass_matrix(report);
  text += print_risks(report);
  return text;
}

}  // namespace treeline
