#include "emission/print_link_table.hpp"

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>
#include <utility>

#include "emission/wrap_line.hpp"
#include "text/printable.hpp"

namespace treeline {
namespace {

using core::loops::Link;
using core::loops::LinkPoint;

std::string number(const Syntax& syntax, double value) {
  if (value == 0) return syntax.literal(0);
  return fmt::format("{}{}", value < 0 ? "-" : "", syntax.literal(std::abs(value)));
}

std::string numbers(const Syntax& syntax, std::span<const double> values) {
  std::string list;
  for (const double value : values) list += (list.empty() ? "" : ", ") + number(syntax, value);
  return "{" + list + "}";
}

std::string print_link(const Syntax& syntax, const Link<double>& of) {
  const double turns[3][2] = {{of.a.c, of.a.s}, {of.alpha.c, of.alpha.s}, {of.b.c, of.b.s}};
  return fmt::format("{{{}, {}, {}, {}, {}, {}, {}, {}, {}, {}, {}}}", of.parent, of.slot,
                     of.slides, numbers(syntax, turns[0]), numbers(syntax, turns[1]),
                     numbers(syntax, turns[2]), numbers(syntax, of.p), number(syntax, of.rotor),
                     number(syntax, of.mass), numbers(syntax, of.h), numbers(syntax, of.J));
}

std::string print_point(const Syntax& syntax, const LinkPoint<double>& of) {
  return fmt::format("{{{}, {}, {}, {}}}", of.link, of.world, numbers(syntax, of.axes),
                     numbers(syntax, of.p));
}

LinkTableText print_link_table(const LinkTableData& table, const Syntax& syntax) {
  LinkTableText text{&table, false, {}, {}, {}, {}, {}, {}, numbers(syntax, table.gravity)};
  for (std::size_t i = 0; i < table.links.size(); ++i) {
    text.links += fmt::format("    // {}\n", printable(table.names[i])) +
                  wrap_line(print_link(syntax, table.links[i]) + ",", 4);
  }
  for (const LinkPoint<double>& point : table.points) {
    text.points += wrap_line(print_point(syntax, point) + ",", 4);
  }
  for (const core::loops::PointRow& row : table.rows) {
    text.rows += fmt::format("    {{{}, {}, {}}},\n", row.point, row.axis, row.angular);
  }
  for (const core::loops::LinkDrive<double>& drive : table.drives) {
    const double row[] = {drive.damping, drive.stiffness, drive.rest};
    text.drives += wrap_line(numbers(syntax, row) + ",", 4);
  }
  for (const core::loops::LinkFriction<double>& friction : table.frictions) {
    const double row[] = {friction.force, friction.sharpness};
    text.frictions += wrap_line(numbers(syntax, row) + ",", 4);
  }
  for (const core::loops::LinkCoupling<double>& coupling : table.couplings) {
    text.couplings += fmt::format("    {{{}, {}, {}}},\n", coupling.joint,
                                  number(syntax, coupling.multiplier), coupling.spins);
  }
  return text;
}

}  // namespace

std::string print_yields(const LinkLoops& loops, const Syntax& syntax) {
  return loops.yields.empty() ? std::string() : numbers(syntax, loops.yields);
}

std::size_t count_base_entries(const LinkTableData& table) {
  if (table.couplings.empty()) return table.floats ? 36 : 1;
  const auto nv = static_cast<std::size_t>(table.joints) + (table.floats ? 5 : 0);
  return nv * (nv + table.rows.size());
}

bool has_points(const LinkTableData& table) {
  return !table.points.empty();
}

std::vector<LinkTableText> list_link_tables(std::span<const Program> programs,
                                            const Syntax& syntax) {
  std::vector<LinkTableText> tables;
  for (const Program& program : programs) {
    if (!program.loops) continue;
    LinkTableText text = print_link_table(program.loops->table, syntax);
    bool is_new = true;
    for (const LinkTableText& other : tables) {
      const bool around_same = other.data->around_points == text.data->around_points;
      const bool same_kind = around_same && has_points(*other.data) == has_points(*text.data);
      const bool same_links = other.links == text.links && other.drives == text.drives &&
                              other.frictions == text.frictions &&
                              other.couplings == text.couplings;
      const bool same_points = other.points == text.points && other.rows == text.rows;
      const bool alike = other.data->links.size() == text.data->links.size() &&
                         other.data->slots == text.data->slots;
      if (!alike || (around_same && !same_links) || (same_kind && !same_points)) {
        throw std::logic_error(program.name + ": a table of links of its own");
      }
      text.shares = text.shares || around_same;
      is_new = is_new && !same_kind;
    }
    if (is_new) tables.push_back(std::move(text));
  }
  return tables;
}

}  // namespace treeline
