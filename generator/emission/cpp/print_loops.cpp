#include "emission/cpp/print_loops.hpp"

#include <fmt/format.h>

#include <initializer_list>
#include <span>
#include <utility>

#include "emission/cpp/syntax.hpp"
#include "emission/cpp/templates.hpp"
#include "emission/fill_template.hpp"
#include "emission/print_link_table.hpp"
#include "emission/wrap_line.hpp"

namespace treeline::cpp {
namespace {

const char* prefix_of(const LinkTableData& table) {
  return table.around_points ? "Point" : "";
}

std::string table_name(const LinkTableData& table) {
  return fmt::format("k{}{}Table", prefix_of(table),
                     table.around_points && !has_points(table) ? "Link" : "");
}

/// The words up to the last of what a table has: defaults say the rest.
std::string join_to_last(std::initializer_list<std::pair<bool, std::string>> words) {
  std::string text;
  std::string missing;
  for (const auto& [has, word] : words) {
    missing += ", " + word;
    if (has) text += std::exchange(missing, {});
  }
  return text;
}

/// What a table says of springs, friction and couplings, behind the arguments that it always has.
std::string print_kinds(const LinkTableData& table) {
  const auto kind = [](const auto& list) {
    return std::pair(!list.empty(), fmt::format("{}", !list.empty()));
  };
  return join_to_last({kind(table.drives), kind(table.frictions), kind(table.couplings)});
}

/// The table's lists behind gravity, up to the last that it has.
std::string print_lists(const LinkTableData& table, const std::string& prefix) {
  const auto list = [&](bool has, const char* name) {
    return std::pair(has, has ? fmt::format("&k{}{}[0]", prefix, name) : "nullptr");
  };
  const auto points =
      fmt::format("&kPoints[0], {}, &kPointRows[0], {}", table.points.size(), table.rows.size());
  return join_to_last({{has_points(table), has_points(table) ? points : "nullptr, 0, nullptr, 0"},
                       list(!table.drives.empty(), "Drives"),
                       list(!table.frictions.empty(), "Frictions"),
                       list(!table.couplings.empty(), "Couplings"),
                       {!table.couplings.empty(), fmt::format("{}", table.joints)}});
}

std::string print_table(const LinkTableText& table) {
  const LinkTableData& data = *table.data;
  const char* const prefix = prefix_of(data);
  const std::size_t links = data.links.size();
  std::string text;
  const auto declare = [&](const char* type, const char* name, const std::string& rows) {
    if (rows.empty() || table.shares) return;
    text += fmt::format("inline constexpr loops::{}<Real> k{}{}[{}] = {{\n{}}};\n", type, prefix,
                        name, links, rows);
  };
  declare("Link", "Links", table.links);
  declare("LinkDrive", "Drives", table.drives);
  declare("LinkFriction", "Frictions", table.frictions);
  declare("LinkCoupling", "Couplings", table.couplings);
  if (has_points(data)) {
    text += fmt::format(
        "inline constexpr loops::LinkPoint<Real> kPoints[{0}] = {{\n{1}}};\n"
        "inline constexpr loops::PointRow kPointRows[{2}] = {{\n{3}}};\n",
        data.points.size(), table.points, data.rows.size(), table.rows);
  }
  const std::string head =
      fmt::format("inline constexpr loops::LinkTable<Real, {}, {}{}> {}", data.floats, data.sliding,
                  print_kinds(data), table_name(data));
  return text + wrap_line(fmt::format("{} = {{&k{}Links[0], {}, {}, {}{}}};", head, prefix, links,
                                      data.slots, table.gravity, print_lists(data, prefix)),
                          0);
}

std::string element(const Argument& argument) {
  return fmt::format("&{}[0]", argument.name);
}

/// The constants of the function's law, if it has one. They are the function's own: two of the
/// namespace would meet where a build joins sources.
std::string print_borders(const EmissionContext& context, const LinkLoops& loops) {
  const std::string yields = print_yields(loops, make_syntax(context));
  if (yields.empty()) return {};
  return "  // Borders of the pivots of rows that yield, to the power of their law.\n" +
         wrap_line(
             fmt::format("static constexpr Real kYields[{}] = {};", loops.yields.size(), yields),
             2);
}

}  // namespace

std::string print_loop_body(const EmissionContext& context, const Program& program) {
  const LinkLoops& loops = *program.loops;
  const LinkTableData& table = loops.table;
  const std::size_t links = table.links.size();
  std::string work = "motions";
  std::string text = print_borders(context, loops);
  text += fmt::format("  detail::loops::MotionWork<Real, {}, {}> motions;\n", links, table.slots);
  if (loops.uses_inertias) {
    text += fmt::format("  detail::loops::InertiaWork<Real, {}, {}, {}> inertias;\n", links,
                        table.slots, count_base_entries(table));
    work += ", inertias";
  }
  if (loops.uses_rows) {
    text += fmt::format("  detail::loops::RowWork<Real, {}, {}> rows;\n", table.points.size(),
                        table.rows.size());
    work += ", rows";
  }
  const auto& arguments = program.arguments;
  const bool given = arguments.size() > 1 && arguments[1].name == "sin_q";
  std::string list = fmt::format("detail::{}, ", table_name(table));
  if (loops.solves) {
    list += loops.yields.empty() ? "static_cast<const Real*>(nullptr), " : "&kYields[0], ";
  }
  list += element(arguments[0]);
  list += given ? ", detail::loops::GivenSines<Real>{&sin_q[0], &cos_q[0]}"
                : ", detail::loops::ComputedSines{}";
  for (std::size_t i = given ? 3 : 1; i < arguments.size(); ++i) {
    list += ", " + element(arguments[i]);
  }
  list += ", " + element(program.results.front().argument);
  return text +
         wrap_line(fmt::format("detail::loops::{}{}({}, {});", loops.function,
                               loops.solves ? fmt::format("<{}>", loops.power) : "", list, work),
                   2);
}

std::vector<GeneratedFile> print_loops(const EmissionContext& context,
                                       std::span<const Program> programs) {
  const std::vector<LinkTableText> tables = list_link_tables(programs, make_syntax(context));
  if (tables.empty()) return {};
  std::string text;
  for (const LinkTableText& table : tables) text += (text.empty() ? "" : "\n") + print_table(table);
  return {{context.name + "_links.hpp",
           fill_template(templates::kLinks,
                         {{"robot", context.robot}, {"name", context.name}, {"tables", text}})}};
}

}  // namespace treeline::cpp
