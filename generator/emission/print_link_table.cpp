#include "emission/print_link_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <stdexcept>
#include <utility>

#include "emission/c_family_syntax.hpp"
#include "emission/emitted_text.hpp"
#include "emission/print_link_inputs.hpp"
#include "text/printable.hpp"

namespace treeline {
namespace {

std::string numbers(const Syntax& syntax, std::span<const double> values) {
  std::string list;
  for (const double value : values)
    list += (list.empty() ? "" : ", ") + signed_literal(syntax, value);
  return "{" + list + "}";
}

std::string print_link(const Syntax& syntax, const LinkTypes::TlLink& of) {
  const double turns[3][2] = {{of.a.c, of.a.s}, {of.alpha.c, of.alpha.s}, {of.b.c, of.b.s}};
  return fmt::format("{{{}, {}, {}, {}, {}, {}, {}, {}, {}, {}, {{{}, {}, {}}}}}", of.parent,
                     of.slot, of.end, of.slides, of.starts, numbers(syntax, turns[0]),
                     numbers(syntax, turns[1]), numbers(syntax, turns[2]), numbers(syntax, of.p),
                     signed_literal(syntax, of.rotor), signed_literal(syntax, of.body.mass),
                     numbers(syntax, of.body.h), numbers(syntax, of.body.J));
}

/// Frames of an input, or the numbers that it has in place of them.
std::string print_frames(const Syntax& syntax, const LinkInput& input) {
  std::string text;
  for (const LinkTypes::TlInputNumber& number : input.numbers) {
    text += fmt::format("    {{{}, {}, {}}},\n", number.of, number.at,
                        signed_literal(syntax, number.factor));
  }
  for (const LinkTypes::TlInputFrame& frame : input.frames) {
    text += wrap_line(fmt::format("{{{}, {}, {{{}}}, {}}},", frame.of, frame.at,
                                  numbers(syntax, frame.R.Q), numbers(syntax, frame.p)),
                      4);
  }
  return text;
}

std::string print_point(const Syntax& syntax, const LinkTypes::TlLinkPoint& of) {
  return fmt::format("{{{}, {}, {}, {}}}", of.link, of.world, numbers(syntax, of.axes),
                     numbers(syntax, of.p));
}

/// Whether two tables have the same of what they share.
bool agree(const LinkTableText& one, const LinkTableText& other) {
  const LinkTableData& a = *one.data;
  const LinkTableData& b = *other.data;
  if (a.slots != b.slots) return false;
  const bool same_links = one.links == other.links && one.drives == other.drives &&
                          one.frictions == other.frictions && one.couplings == other.couplings &&
                          one.balls == other.balls && one.pushed_points == other.pushed_points;
  const bool same_points =
      one.points == other.points && one.rows == other.rows && one.row_entries == other.row_entries;
  return same_links && (same_points || a.points.empty() != b.points.empty());
}

}  // namespace

LinkTableText print_link_table(const LinkTableData& table, const Syntax& syntax) {
  LinkTableText text;
  text.data = &table;
  for (const double g : table.gravity) text.gravity.push_back(signed_literal(syntax, g));
  for (std::size_t i = 0; i < table.links.size(); ++i) {
    text.links += fmt::format("    // {}\n", printable(table.names[i])) +
                  wrap_line(print_link(syntax, table.links[i]) + ",", 4);
  }
  for (const LinkTypes::TlLinkPoint& point : table.points) {
    text.points += wrap_line(print_point(syntax, point) + ",", 4);
  }
  for (const LinkTypes::TlLinkPoint& point : table.pushed_points) {
    text.pushed_points += wrap_line(print_point(syntax, point) + ",", 4);
  }
  for (const LinkTypes::TlPointRow& row : table.rows) {
    text.rows += fmt::format("    {{{}, {}, {}}},\n", row.point, row.axis, row.angular);
  }
  if (!table.row_entries.empty()) {
    text.row_entries = wrap_line(fmt::format("{}", fmt::join(table.row_entries, ", ")), 4);
  }
  for (const LinkTypes::TlLinkDrive& drive : table.drives) {
    const double row[] = {drive.damping, drive.stiffness, drive.rest};
    text.drives += wrap_line(numbers(syntax, row) + ",", 4);
  }
  for (const LinkTypes::TlLinkFriction& friction : table.frictions) {
    const double row[] = {friction.force, friction.sharpness};
    text.frictions += wrap_line(numbers(syntax, row) + ",", 4);
  }
  for (const LinkTypes::TlLinkCoupling& coupling : table.couplings) {
    text.couplings +=
        fmt::format("    {{{}, {}, {}, {}}},\n", coupling.joint,
                    signed_literal(syntax, coupling.multiplier), coupling.spins, coupling.own_sine);
  }
  for (const LinkTypes::TlLinkBall& ball : table.balls) {
    text.balls += fmt::format("    {{{}, {}, {}}},\n", ball.axis, ball.rotation, ball.q);
  }
  for (const std::int16_t link : table.loaded_links) {
    text.loaded_links += fmt::format("    {},  // {}\n", link,
                                     printable(table.names[static_cast<std::size_t>(link)]));
  }
  for (const LinkInput& input : table.inputs) text.frames.push_back(print_frames(syntax, input));
  return text;
}

std::string print_yields(const LinkLoops& loops, const Syntax& syntax, const std::string& name) {
  if (loops.yields.empty()) return {};
  return (is_ranked(loops)
              ? "  // What is added to inverse inertias of points, a share of which are the "
                "borders.\n"
              : "  // Borders of the pivots of rows that yield, to the power of their law.\n") +
         wrap_line(
             fmt::format("{}[{}] = {};", name, loops.yields.size(), numbers(syntax, loops.yields)),
             2);
}

bool is_ranked(const LinkLoops& loops) {
  return loops.power == kPowerOfPriorities;
}

std::size_t count_base_entries(const LinkTableData& table) {
  if (table.couplings.empty()) return table.floats ? 36 : 1;
  const auto nv = static_cast<std::size_t>(table.joints) + (table.floats ? 5 : 0);
  return nv * (nv + table.rows.size());
}

std::vector<LinkArray> list_arrays(const LinkTableText& table) {
  const LinkTableData& data = *table.data;
  const std::size_t links = data.links.size();
  std::vector<LinkArray> of_links = {
      {"TlLink", "links", links, table.links},
      {"TlLinkDrive", "drives", links, table.drives},
      {"TlLinkFriction", "frictions", links, table.frictions},
      {"TlLinkCoupling", "couplings", links, table.couplings},
      {"TlLinkBall", "ball_axes", links, table.balls},
      {"int16_t", "loaded_links", data.loaded_links.size(), table.loaded_links},
      {"TlLinkPoint", "pushed_points", data.pushed_points.size(), table.pushed_points}};
  std::vector<LinkArray> of_points = {
      {"TlLinkPoint", "points", data.points.size(), table.points},
      {"TlPointRow", "point_rows", data.rows.size(), table.rows},
      {"int16_t", "row_entries", data.row_entries.size(), table.row_entries}};
  for (std::size_t i = 0; i < data.inputs.size(); ++i) {
    const LinkInput& input = data.inputs[i];
    std::vector<LinkArray>& of = input.is_of_points() ? of_points : of_links;
    const bool has_frames = input.numbers.empty();
    of.push_back({has_frames ? "TlInputFrame" : "TlInputNumber", frames_name(input),
                  has_frames ? input.frames.size() : input.numbers.size(), table.frames[i]});
    if (input.entries.empty()) continue;
    of_links.push_back({"int16_t", entries_name(input), input.entries.size(),
                        wrap_line(fmt::format("{}", fmt::join(input.entries, ", ")), 4)});
  }
  std::vector<LinkArray> arrays;
  if (!table.shares) arrays = std::move(of_links);
  arrays.insert(arrays.end(), of_points.begin(), of_points.end());
  std::erase_if(arrays, [](const LinkArray& array) { return array.rows.empty(); });
  return arrays;
}

bool has_points(const LinkTableData& table) {
  return !table.points.empty();
}

bool changes_table(const LinkLoops& loops) {
  return !loops.gravity.empty() || !loops.f_ext.empty() || !loops.step.empty() ||
         !loops.table.inputs.empty();
}

bool changes_table(const LinkLoops& loops, const std::string& argument) {
  const auto& inputs = loops.table.inputs;
  return argument == loops.gravity || argument == loops.f_ext || argument == loops.step ||
         std::any_of(inputs.begin(), inputs.end(),
                     [&](const LinkInput& input) { return input.argument == argument; });
}

bool has_inputs(std::span<const Program> programs) {
  return std::any_of(programs.begin(), programs.end(), [](const Program& program) {
    return program.loops && !program.loops->table.inputs.empty();
  });
}

std::vector<LinkTableText> list_link_tables(std::span<const Program> programs,
                                            const Syntax& syntax) {
  std::vector<LinkTableText> tables;
  for (const Program& program : programs) {
    if (!program.loops) continue;
    LinkTableText text = print_link_table(program.loops->table, syntax);
    text.is_constant = !changes_table(*program.loops);
    bool is_new = true;
    for (LinkTableText& other : tables) {
      if (!agree(text, other)) {
        throw std::logic_error(program.name + ": a table of links of its own");
      }
      text.shares = true;
      if (has_points(*other.data) != has_points(*text.data)) continue;
      is_new = false;
      other.is_constant = other.is_constant || text.is_constant;
    }
    if (is_new) tables.push_back(std::move(text));
  }
  return tables;
}

}  // namespace treeline
