#include "emission/cpp/print_loops.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <span>
#include <stdexcept>

#include "description/printable.hpp"
#include "emission/cpp/syntax.hpp"
#include "emission/cpp/templates.hpp"
#include "emission/fill_template.hpp"
#include "emission/wrap_line.hpp"
#include "program/link_loops.hpp"

namespace treeline::cpp {
namespace {

using core::loops::Link;
using core::loops::LinkPoint;

class TablePrinter {
 public:
  explicit TablePrinter(const EmissionContext& context) : syntax_(make_syntax(context)) {}

  [[nodiscard]] std::string number(double value) const {
    if (value == 0) return syntax_.literal(0);
    return (value < 0 ? "-" : "") + syntax_.literal(std::abs(value));
  }
  [[nodiscard]] std::string numbers(std::span<const double> values) const {
    std::string list;
    for (const double value : values) list += (list.empty() ? "" : ", ") + number(value);
    return "{" + list + "}";
  }
  [[nodiscard]] std::string link(const Link<double>& of) const {
    const double turns[3][2] = {{of.a.c, of.a.s}, {of.alpha.c, of.alpha.s}, {of.b.c, of.b.s}};
    return fmt::format("{{{}, {}, {}, {}, {}, {}, {}, {}, {}, {}, {}, {}}}", of.parent, of.slot,
                       of.slides, numbers(turns[0]), numbers(turns[1]), numbers(turns[2]),
                       numbers(of.p), number(of.offset), number(of.rotor), number(of.mass),
                       numbers(of.h), numbers(of.J));
  }
  [[nodiscard]] std::string point(const LinkPoint<double>& of) const {
    std::string rows;
    for (const bool row : of.rows) rows += fmt::format("{}{}", rows.empty() ? "" : ", ", row);
    return fmt::format("{{{}, {}, {{{}}}, {}, {}}}", of.link, of.world, rows, numbers(of.axes),
                       numbers(of.p));
  }

 private:
  Syntax syntax_;
};

/// Functions of points have link frames of their own, placed around these.
const char* prefix_of(const LinkTableData& table) {
  return table.points.empty() ? "" : "Point";
}

std::string print_table(const TablePrinter& printer, const LinkTableData& table) {
  const char* const prefix = prefix_of(table);
  std::string text = fmt::format("inline constexpr loops::Link<Real> k{}Links[{}] = {{\n", prefix,
                                 table.links.size());
  for (std::size_t i = 0; i < table.links.size(); ++i) {
    text += fmt::format("    // {}\n", printable(table.names[i])) +
            wrap_line(printer.link(table.links[i]) + ",", 4);
  }
  text += "};\n";
  std::string points;
  if (!table.points.empty()) {
    text += fmt::format("inline constexpr loops::LinkPoint<Real> kPoints[{}] = {{\n",
                        table.points.size());
    for (const LinkPoint<double>& point : table.points) {
      text += wrap_line(printer.point(point) + ",", 4);
    }
    text += "};\n";
    points = fmt::format(", kPoints, {}, {}", table.points.size(), table.rows);
  }
  return text +
         wrap_line(fmt::format("inline constexpr loops::LinkTable<Real, {}, {}> k{}Table = "
                               "{{k{}Links, {}, {}, {}{}}};",
                               table.floats, table.sliding, prefix, prefix, table.links.size(),
                               table.slots, printer.numbers(table.gravity), points),
                   0);
}

/// The texts of the tables that the functions use, each once: with and without points.
std::vector<std::string> print_tables(const EmissionContext& context,
                                      std::span<const Program> programs) {
  const TablePrinter printer(context);
  std::vector<std::string> tables, prefixes;
  for (const Program& program : programs) {
    if (!program.loops) continue;
    std::string text = print_table(printer, program.loops->table);
    if (std::find(tables.begin(), tables.end(), text) != tables.end()) continue;
    std::string prefix = prefix_of(program.loops->table);
    if (std::find(prefixes.begin(), prefixes.end(), prefix) != prefixes.end()) {
      throw std::logic_error(program.name + ": a table of links of its own");
    }
    tables.push_back(std::move(text));
    prefixes.push_back(std::move(prefix));
  }
  return tables;
}

std::string element(const Argument& argument) {
  return fmt::format("&{}[0]", argument.name);
}

/// The constants of the function's law, if it has one. They are the function's own: two of the
/// namespace would meet where a build joins sources.
std::string print_yields(const EmissionContext& context, const LinkLoops& loops) {
  if (loops.yields.empty()) return {};
  return "  // Borders of the pivots of rows that yield, to the power of their law.\n" +
         wrap_line(fmt::format("static constexpr Real kYields[{}] = {};", loops.yields.size(),
                               TablePrinter(context).numbers(loops.yields)),
                   2);
}

}  // namespace

std::string print_loop_body(const EmissionContext& context, const Program& program) {
  const LinkLoops& loops = *program.loops;
  const LinkTableData& table = loops.table;
  const std::size_t links = table.links.size();
  std::string work = "motions";
  std::string text = print_yields(context, loops);
  text += fmt::format("  detail::loops::MotionWork<Real, {}, {}, {}> motions;\n", links,
                      table.slots, table.points.size());
  if (loops.uses_inertias) {
    text += fmt::format("  detail::loops::InertiaWork<Real, {}, {}, {}> inertias;\n", links,
                        table.slots, table.floats);
    work += ", inertias";
  }
  if (loops.uses_rows) {
    text += fmt::format("  detail::loops::RowWork<Real, {}, {}> rows;\n", table.points.size(),
                        table.rows);
    work += ", rows";
  }
  const auto& arguments = program.arguments;
  const bool given = arguments.size() > 1 && arguments[1].name == "sin_q";
  std::string list = fmt::format("detail::k{}Table, ", prefix_of(table));
  if (loops.solves) {
    list += loops.yields.empty() ? "static_cast<const Real*>(nullptr), " : "kYields, ";
  }
  list += element(arguments[0]);
  list += given ? ", detail::loops::GivenSines<Real>{&sin_q[0], &cos_q[0]}"
                : ", detail::loops::ComputedSines{}";
  for (std::size_t i = given ? 3 : 1; i < arguments.size(); ++i) {
    list += ", " + element(arguments[i]);
  }
  list += ", " + element(program.results.front().argument);
  return text +
         wrap_line(fmt::format("detail::loops::{}{}({}, {});", program.name,
                               loops.solves ? fmt::format("<{}>", loops.power) : "", list, work),
                   2);
}

std::vector<GeneratedFile> print_loops(const EmissionContext& context,
                                       std::span<const Program> programs) {
  const std::vector<std::string> tables = print_tables(context, programs);
  if (tables.empty()) return {};
  std::string text;
  for (const std::string& table : tables) text += (text.empty() ? "" : "\n") + table;
  return {{context.name + "_links.hpp",
           fill_template(templates::kLinks,
                         {{"robot", context.robot}, {"name", context.name}, {"tables", text}})}};
}

}  // namespace treeline::cpp
