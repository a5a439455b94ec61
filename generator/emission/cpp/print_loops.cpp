#include "emission/cpp/print_loops.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <initializer_list>
#include <span>
#include <utility>

#include "emission/c_family_syntax.hpp"
#include "emission/cpp/syntax.hpp"
#include "emission/cpp/templates.hpp"
#include "emission/fill_template.hpp"
#include "emission/print_link_inputs.hpp"
#include "emission/print_link_table.hpp"
#include "emission/wrap_line.hpp"

namespace treeline::cpp {
namespace {

std::string table_name(const LinkTableData& table) {
  return has_points(table) ? "kPointTable" : "kTable";
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

/// `LinkTable<Real, false, true>`: defaults at its end are left out.
std::string print_type(const LinkTableData& table, bool pushed, bool stepped) {
  const auto kind = [](bool has) { return std::pair(has, fmt::format("{}", has)); };
  return fmt::format(
      "loops::LinkTable<Real, {}, {}{}>", table.floats, table.sliding,
      join_to_last({kind(!table.drives.empty()), kind(!table.frictions.empty()),
                    kind(!table.couplings.empty()), kind(table.own_sines),
                    kind(!table.balls.empty()), kind(pushed), kind(!table.loaded_links.empty()),
                    kind(!table.row_entries.empty()), kind(stepped), kind(table.grounded),
                    kind(table.freed), kind(table.turning)}));
}

/// `kPointRows`, a constant of the robot.
std::string constant_name(const std::string& name) {
  return "k" + in_pascal_case(name);
}

/// The table with its braces, as no argument changes it.
std::string print_value(const LinkTableText& table) {
  const LinkTableData& data = *table.data;
  const auto list = [](bool has, const char* name) {
    return std::pair(has, has ? fmt::format("&{}[0]", constant_name(name)) : "nullptr");
  };
  const std::string points =
      fmt::format("&kPoints[0], {}, &kPointRows[0], {}", data.points.size(), data.rows.size());
  const std::string lists =
      join_to_last({{has_points(data), has_points(data) ? points : "nullptr, 0, nullptr, 0"},
                    list(!data.drives.empty(), "drives"),
                    list(!data.frictions.empty(), "frictions"),
                    list(!data.couplings.empty(), "couplings"),
                    {!data.couplings.empty(), fmt::format("{}", data.joints)},
                    list(!data.balls.empty(), "ball_axes"),
                    list(!data.row_entries.empty(), "row_entries")});
  return fmt::format("{{&kLinks[0], {}, {}, {{{}}}{}}}", data.links.size(), data.slots,
                     fmt::join(table.gravity, ", "), lists);
}

std::string print_link_array(const LinkArray& array) {
  const bool built_in = array.of == LinkArray::Of::built_in;
  return fmt::format("inline constexpr {}{}{} {}[{}] = {{\n{}}};\n",
                     built_in ? "" : "loops::", array.type,
                     array.of == LinkArray::Of::numbers ? "<Real>" : "", constant_name(array.name),
                     array.count, array.rows);
}

std::string print_table(const LinkTableText& table) {
  std::string text;
  for (const LinkArray& array : list_arrays(table)) text += print_link_array(array);
  if (!table.is_constant) return text;
  return text + wrap_line(fmt::format("inline constexpr {} {} = {};",
                                      print_type(*table.data, false, false),
                                      table_name(*table.data), print_value(table)),
                          0);
}

/// The table as arguments of a function change it.
std::string print_own_table(const EmissionContext& context, const LinkLoops& loops) {
  if (!changes_table(loops)) return {};
  const LinkTableData& data = loops.table;
  const LinkTableText text = print_link_table(data, make_syntax(context));
  LoopNames names;
  names.type = [](const std::string& type) { return fmt::format("detail::loops::{}<Real>", type); };
  names.function = [](const std::string& function) { return "detail::loops::" + function; };
  names.array = [](const std::string& array) { return fmt::format("&{}[0]", array); };
  names.constant = [](const std::string& name) {
    return fmt::format("&detail::{}[0]", constant_name(name));
  };
  names.none = "nullptr";
  names.number = "Real";
  names.table = "table";
  return print_link_inputs(loops, names) +
         print_members(loops, names,
                       "detail::" + print_type(data, !loops.f_ext.empty(), changes_rotors(loops)),
                       text.gravity, false);
}

std::string element(const Argument& argument) {
  return fmt::format("&{}[0]", argument.name);
}

}  // namespace

std::string print_loop_body(const EmissionContext& context, const Program& program) {
  const LinkLoops& loops = *program.loops;
  const LinkTableData& table = loops.table;
  const std::size_t links = table.links.size();
  std::string work = "motions";
  // The law's constants are the function's own: two of the namespace would meet where a build joins
  // sources.
  std::string text = print_yields(loops, make_syntax(context), "static constexpr Real kYields") +
                     print_own_table(context, loops);
  text += fmt::format("  detail::loops::MotionWork<Real, {}, {}{}> motions;\n", links, table.slots,
                      table.rotations > 1 ? fmt::format(", {}", table.rotations) : "");
  if (loops.uses_inertias) {
    text += fmt::format("  detail::loops::InertiaWork<Real, {}, {}, {}> inertias;\n", links,
                        table.slots, count_base_entries(table));
    work += ", inertias";
  }
  if (loops.uses_matrix) {
    text += fmt::format("  detail::loops::MatrixWork<Real, {}, {}> matrices;\n", links,
                        count_base_entries(table));
    work += ", matrices";
  }
  if (loops.uses_rows) {
    text += fmt::format("  detail::loops::RowWork<Real, {}, {}{}> rows;\n", table.points.size(),
                        table.rows.size(),
                        is_ranked(loops) ? fmt::format(", {}", table.rows.size()) : "");
    work += ", rows";
  }
  const auto& arguments = program.arguments;
  const bool given = arguments.size() > 1 && arguments[1].name == "sin_q";
  std::string list =
      changes_table(loops) ? "table, " : fmt::format("detail::{}, ", table_name(table));
  if (loops.solves) {
    list += loops.yields.empty() ? "static_cast<const Real*>(nullptr), " : "&kYields[0], ";
  }
  list += element(arguments[0]);
  list += given ? ", detail::loops::GivenSines<Real>{&sin_q[0], &cos_q[0]}"
                : ", detail::loops::ComputedSines{}";
  for (std::size_t i = given ? 3 : 1; i < arguments.size(); ++i) {
    if (!changes_table(loops, arguments[i].name)) list += ", " + element(arguments[i]);
  }
  list += ", " + element(program.results.front().argument);
  return text +
         wrap_line(fmt::format("detail::loops::{}{}({}, {});", loops.function,
                               loops.solves ? fmt::format("<{}>", loops.power) : "", list, work),
                   2);
}

GeneratedFile print_link_tables(const EmissionContext& context, std::span<const Program> programs) {
  std::string text;
  for (const LinkTableText& table : list_link_tables(programs, make_syntax(context))) {
    text += (text.empty() ? "" : "\n") + print_table(table);
  }
  return {context.name + "_links.hpp",
          fill_template(templates::kLinks,
                        {{"robot", context.robot},
                         {"name", context.name},
                         {"header", has_inputs(programs) ? "link_inputs" : "link_table"},
                         {"tables", text}})};
}

}  // namespace treeline::cpp
