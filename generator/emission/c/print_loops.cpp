#include "emission/c/print_loops.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <sstream>
#include <tuple>
#include <utility>

#include "emission/c/syntax.hpp"
#include "emission/c/templates.hpp"
#include "emission/c/translate_loops.hpp"
#include "emission/c_family_syntax.hpp"
#include "emission/describe_program.hpp"
#include "emission/fill_template.hpp"
#include "emission/inline_links.hpp"
#include "emission/keep_called.hpp"
#include "emission/loop_templates.hpp"
#include "emission/print_link_inputs.hpp"
#include "emission/print_link_table.hpp"
#include "emission/wrap_line.hpp"

namespace treeline::c {
namespace {

bool takes_sines(const Program& program) {
  return program.arguments.size() > 1 && program.arguments[1].name == "sin_q";
}

std::string table_name(const EmissionContext& context, const LinkTableData& table) {
  return fmt::format("{}_{}table", context.name, has_points(table) ? "point_" : "");
}

/// The table with its braces, as no argument changes it.
std::string print_value(const EmissionContext& context, const LinkTableText& table) {
  const LinkTableData& data = *table.data;
  const auto list = [&](bool has, const char* name) {
    return has ? fmt::format("{}_{}", context.name, name) : "NULL";
  };
  const bool points = has_points(data);
  return fmt::format(
      "{{{}, {}, {}, {{{}}}, {}, {}, {}, {}, {}, {}, {}, {}, {}, {}, NULL, 0, NULL, NULL, NULL, 0, "
      "NULL, NULL}}",
      list(true, "links"), data.links.size(), data.slots, fmt::join(table.gravity, ", "),
      list(points, "points"), data.points.size(), list(points, "point_rows"), data.rows.size(),
      list(!data.drives.empty(), "drives"), list(!data.frictions.empty(), "frictions"),
      list(!data.couplings.empty(), "couplings"), data.joints,
      list(!data.balls.empty(), "ball_axes"), list(!data.row_entries.empty(), "row_entries"));
}

std::string print_link_array(const EmissionContext& context, const LinkArray& array) {
  const std::string type = array.of == LinkArray::Of::built_in
                               ? array.type
                               : context.name + "_loops_" + in_snake_case(array.type);
  return fmt::format("static const {} {}_{}[{}] = {{\n{}}};\n", type, context.name, array.name,
                     array.count, array.rows);
}

std::string print_table(const EmissionContext& context, const LinkTableText& table) {
  std::string text;
  for (const LinkArray& array : list_arrays(table)) text += print_link_array(context, array);
  if (!table.is_constant) return text;
  return text +
         wrap_line(fmt::format("static const {}_loops_link_table {} = {};", context.name,
                               table_name(context, *table.data), print_value(context, table)),
                   0);
}

/// The table as arguments of a function change it.
std::string print_own_table(const EmissionContext& context, const LinkLoops& loops) {
  if (!changes_table(loops)) return {};
  const std::string prefix = context.name + "_loops_";
  const LinkTableText text = print_link_table(loops.table, make_syntax(context));
  LoopNames names;
  names.type = [&](const std::string& type) { return prefix + in_snake_case(type); };
  names.function = [&](const std::string& function) { return prefix + function; };
  names.array = [](const std::string& array) { return array; };
  names.constant = [&](const std::string& name) {
    return fmt::format("{}_{}", context.name, name);
  };
  names.none = "NULL";
  names.number = number_type(context);
  names.table = "&table";
  return print_link_inputs(loops, names) +
         print_members(loops, names, prefix + "link_table", text.gravity, true);
}

bool has_own_rotors(const Program& program) {
  return program.loops && changes_rotors(*program.loops);
}

/// The table that has what others have. `programs` have loops.
const LinkTableData& find_largest(std::span<const Program> programs) {
  const LinkTableData* largest = nullptr;
  for (const Program& program : programs) {
    if (!program.loops) continue;
    const LinkTableData& table = program.loops->table;
    if (largest == nullptr || has_points(table)) largest = &table;
  }
  return *largest;
}

/// Finds the features that the robot's tables have.
LoopTable list_kinds(const LinkTableData& table, bool stepped) {
  return {.floats = table.floats,
          .sliding = table.sliding,
          .driven = !table.drives.empty(),
          .rubbing = !table.frictions.empty(),
          .coupled = !table.couplings.empty(),
          .own_sines = table.own_sines,
          .balls = !table.balls.empty(),
          .pushed = !table.pushed_points.empty(),
          .loaded = !table.loaded_links.empty(),
          .sorted = !table.row_entries.empty(),
          .stepped = stepped,
          .grounded = table.grounded,
          .freed = table.freed,
          .turning = table.turning};
}

/// Sizes of arrays: constants in C, where C++ has parameters of templates.
std::string print_sizes(const EmissionContext& context, const LinkTableData& table, bool ranked) {
  const auto one_or = [](std::size_t count) { return std::max<std::size_t>(count, 1); };
  const std::pair<const char*, std::size_t> sizes[] = {
      {"LINKS", table.links.size()},
      {"SLOTS", static_cast<std::size_t>(table.slots)},
      {"TURNED", static_cast<std::size_t>(table.rotations)},
      {"POINTS", one_or(table.points.size())},
      {"ROWS", one_or(table.rows.size())},
      {"RANKED", ranked ? table.rows.size() : 1},
      {"BASE_ENTRIES", count_base_entries(table)}};
  std::string text;
  for (const auto& [name, size] : sizes) {
    text += fmt::format("{}  {}_LOOPS_{} = {}", text.empty() ? "" : ",\n",
                        name_in_capitals(context), name, size);
  }
  return fmt::format("/// Of the robot's tables.\nenum {{\n{}\n}};\n", text);
}

/// Start of a header, with its comments and includes, as C has it.
std::string print_opening(std::string_view header) {
  std::string text;
  std::istringstream lines{std::string(header)};
  for (std::string line; std::getline(lines, line) && !line.starts_with("namespace ");) {
    const std::size_t standard = line.find("C++17");
    if (standard != line.npos) line.replace(standard, 5, "C99");
    const std::size_t file = line.find(".hpp\"");
    if (line.starts_with("#include \"core/") && file != line.npos) {
      line = "#include \"" + line.substr(15, file - 15) + ".h\"";
    }
    // C++ has the types bool and nullptr without a header.
    if (line == "#include <stdint.h>") text += "#include <stdbool.h>\n#include <stddef.h>\n";
    text += line + "\n";
  }
  return text;
}

}  // namespace

std::string print_loop_body(const EmissionContext& context, const Program& program) {
  const LinkLoops& loops = *program.loops;
  const std::string prefix = context.name + "_loops_";
  std::string text = print_yields(loops, make_syntax(context),
                                  fmt::format("static const {} yields", number_type(context)));
  std::string list = loops.solves ? fmt::format("{}, ", loops.power) : "";
  text += print_own_table(context, loops);
  list += "&" + (changes_table(loops) ? "table" : table_name(context, loops.table));
  if (loops.solves) list += loops.yields.empty() ? ", NULL" : ", yields";
  for (const Argument& argument : program.arguments) {
    if (!changes_table(loops, argument.name)) list += ", " + argument.name;
  }
  list += ", " + program.results.front().argument.name;
  const std::tuple<const char*, const char*, bool> works[] = {
      {"motion", "motions", true},
      {"inertia", "inertias", loops.uses_inertias},
      {"matrix", "matrices", loops.uses_matrix},
      {"row", "rows", loops.uses_rows}};
  for (const auto& [work, name, used] : works) {
    if (!used) continue;
    text += fmt::format("  {}{}_work {};\n", prefix, work, name);
    list += fmt::format(", &{}", name);
  }
  return text + wrap_line(fmt::format("{}{}({});", prefix, loops.function, list), 2);
}

namespace {

/// NAME_links.h.
GeneratedFile print_tables(const EmissionContext& context, std::span<const Program> programs) {
  std::string text;
  for (const LinkTableText& table : list_link_tables(programs, make_syntax(context))) {
    text += (text.empty() ? "" : "\n") + print_table(context, table);
  }
  return {context.name + "_links.h",
          fill_template(templates::kLinks,
                        {{"robot", context.robot},
                         {"name", context.name},
                         {"header", has_inputs(programs) ? "link_inputs" : "link_table"},
                         {"tables", text}})};
}

}  // namespace

std::vector<GeneratedFile> print_loops(const Contents& contents) {
  const EmissionContext& context = contents.context;
  const std::vector<Program>& programs = contents.all;
  const LinkTableData& table = find_largest(programs);
  LoopTranslator translator(
      context, list_kinds(table, std::any_of(programs.begin(), programs.end(), has_own_rotors)),
      std::any_of(programs.begin(), programs.end(), takes_sines));
  const bool ranked = std::any_of(programs.begin(), programs.end(), [](const Program& program) {
    return program.loops && is_ranked(*program.loops);
  });
  std::vector<LoopHeader> translated;
  for (const LoopTemplate& each : list_loop_templates(programs)) {
    const std::string header = settle_inlining(context, each.text, Sharing::compilers);
    LoopHeader& next =
        translated.emplace_back(LoopHeader{each.stem + ".h", print_opening(header), {}});
    if (each.stem == "link_table") {
      next.opening += print_sizes(context, table, ranked) + "\n";
    }
    for (const LoopItem& item : parse_loops(header)) {
      std::string text = translator.translate(item);
      if (text.empty()) continue;
      const std::string name = item.is_struct() ? in_snake_case(item.name()) : item.name();
      next.items.push_back({context.name + "_loops_" + name, !item.is_struct(), std::move(text)});
    }
  }
  const auto print_body = [&](const Program& program) { return print_loop_body(context, program); };
  std::vector<GeneratedFile> files = {print_tables(context, programs)};
  keep_called(join_callers(programs, print_body, files), translated);
  for (const LoopHeader& header : translated) {
    std::string text = header.opening;
    for (const LoopDeclaration& item : header.items) {
      text += (&item == &header.items.front() ? "" : "\n") + item.text;
    }
    files.push_back({header.name, std::move(text)});
  }
  return files;
}

}  // namespace treeline::c
