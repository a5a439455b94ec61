#include <fmt/format.h>

#include <span>
#include <tuple>
#include <utility>
#include <vector>

#include "emission/backend.hpp"
#include "emission/descriptions.hpp"
#include "emission/emitted_text.hpp"
#include "emission/print_files.hpp"
#include "emission/print_link_inputs.hpp"
#include "emission/print_link_table.hpp"
#include "emission/templates.hpp"

namespace treeline {
namespace {

/// Names of the robot's constants beside the loops, in C `arm_links`, in C++ `kLinks`.
std::string constant_of(const EmissionContext& context, const std::string& name) {
  return backend_of(context.language).has_namespaces ? "k" + in_pascal_case(name)
                                                     : context.name + "_" + name;
}

const char* table_name(const LinkTableData& table) {
  return has_points(table) ? "point_table" : "table";
}

/// `scope` is where the robot's constants are. Adds what code names to `used`.
LoopNames name_in(const EmissionContext& context, const std::string& scope, NameSet& used) {
  const bool has_scopes = backend_of(context.language).has_namespaces;
  const Adaptation own = name_loops(context);
  LoopNames names;
  names.in_loops = [own, &used,
                    loops = has_scopes ? scope + "loops::" : ""](const std::string& word) {
    const bool is_there = word.starts_with("Tl") || word.starts_with("tl_");
    if (is_there) used.insert(word);
    return is_there ? loops + adapt_words(word, own) : word;
  };
  names.constant = [context, scope](const std::string& name) {
    return fmt::format("&{}{}[0]", scope, constant_of(context, name));
  };
  names.none = own.words.at("TL_NONE");
  names.number = has_scopes ? "Real" : number_type(context);
  return names;
}

/// A function's own names of what is in the namespace of the robot's details.
LoopNames name_in_function(const EmissionContext& context, NameSet& used) {
  return name_in(context, std::string(backend_of(context.language).details), used);
}

std::string print_array(const Adaptation& own, const LoopNames& names, const std::string& name,
                        const LinkArray& array) {
  return fmt::format("{} {} {}[{}] = {{\n{}}};\n", own.words.at("TL_TABLE"),
                     names.in_loops(array.type), name, array.count, array.rows);
}

std::string print_table(const EmissionContext& context, const LinkTableText& table, NameSet& used) {
  const Adaptation own = name_loops(context);
  const LoopNames names = name_in(context, "", used);
  std::string text;
  for (const LinkArray& array : list_arrays(table)) {
    text += print_array(own, names, constant_of(context, array.name), array);
  }
  if (!table.is_constant) return text;
  LinkLoops unchanged;
  unchanged.table = *table.data;
  std::string values;
  for (const LinkMember& member : list_members(unchanged, names, table.gravity)) {
    values += (values.empty() ? "" : ", ") + member.value;
  }
  return text + wrap_line(fmt::format("{} {} {} = {{{}}};", own.words.at("TL_TABLE"),
                                      names.in_loops("TlLinkTable"),
                                      constant_of(context, table_name(*table.data)), values),
                          0);
}

/// The table as arguments of a function change it, member by member: of an initializer g++ makes a
/// call of memset.
std::string print_own_table(const EmissionContext& context, const LinkLoops& loops,
                            const LoopNames& names) {
  if (!changes_table(loops)) return {};
  const Syntax syntax = backend_of(context.language).syntax(context);
  std::vector<std::string> gravity = print_link_table(loops.table, syntax).gravity;
  std::string text =
      print_link_inputs(loops, names) + fmt::format("  {} table;\n", names.in_loops("TlLinkTable"));
  for (const LinkMember& member : list_members(loops, names, {})) {
    if (std::string_view(member.name) != "gravity") {
      text += fmt::format("  table.{} = {};\n", member.name, member.value);
      continue;
    }
    for (std::size_t k = 0; k < gravity.size(); ++k) {
      if (!loops.gravity.empty()) gravity[k] = fmt::format("{}[{}]", loops.gravity, k);
      text += fmt::format("  table.gravity[{}] = {};\n", k, gravity[k]);
    }
  }
  if (loops.step.empty()) return text;
  return text +
         wrap_line(fmt::format("{}(&table, &qd[0], &rotors[0]);", names.in_loops("tl_find_rotors")),
                   2) +
         "  table.rotors = &rotors[0];\n";
}

GeneratedFile print_tables(const EmissionContext& context, std::span<const Program> programs,
                           NameSet& used) {
  std::string text;
  for (const LinkTableText& table :
       list_link_tables(programs, backend_of(context.language).syntax(context))) {
    text += (text.empty() ? "" : "\n") + print_table(context, table, used);
  }
  Adaptation own = name_loops(context);
  own.part.clear();
  own.words["TL_ROBOT"] = context.robot;
  own.words["TL_NAME"] = context.name;
  own.words["TL_TABLES"] = text;
  return {header_name(context, context.name + "_links"),
          adapt("#pragma once\n// TL_ROBOT: its links as constants, for functions that loop over "
                "them: see\n// link_functions.h.\n#include \"TL_NAME.h\"\n#include "
                "\"link_functions.h\"\n\nTL_TABLES",
                own)};
}

std::string print_body_of(const EmissionContext& context, const Program& program, NameSet& used) {
  const LinkLoops& loops = *program.loops;
  const LoopNames names = name_in_function(context, used);
  const Backend& backend = backend_of(context.language);
  std::string text = print_yields(loops, backend.syntax(context),
                                  fmt::format("static const {} yields", names.number)) +
                     print_own_table(context, loops, names);
  std::string list = loops.solves ? fmt::format("{}, ", loops.power) : "";
  list += changes_table(loops) ? "&table"
                               : fmt::format("&{}{}", backend.details,
                                             constant_of(context, table_name(loops.table)));
  if (loops.solves) list += ", " + (loops.yields.empty() ? names.none : "&yields[0]");
  for (const Argument& argument : program.arguments) {
    const bool is_of_sines = argument.name == "sin_q" || argument.name == "cos_q";
    if (is_of_sines || changes_table(loops, argument.name)) continue;
    list += fmt::format(", &{}[0]", argument.name);
  }
  list += fmt::format(", &{}[0]", program.results.front().argument.name);
  const std::tuple<const char*, const char*, bool> works[] = {
      {"TlMotionWork", "motions", true},
      {"TlFactorWork", "factors", loops.uses_factors},
      {"TlMatrixWork", "matrix", loops.uses_matrix},
      {"TlRowWork", "rows", loops.uses_rows}};
  for (const auto& [work, name, is_used] : works) {
    if (!is_used) continue;
    text += fmt::format("  {} {};\n", names.in_loops(work), name);
    list += fmt::format(", &{}", name);
  }
  if (takes_sines(program)) {
    text += "  motions.poses.sin_q = &sin_q[0];\n  motions.poses.cos_q = &cos_q[0];\n";
  }
  return text + wrap_line(fmt::format("{}({});", names.in_loops("tl_" + loops.function), list), 2);
}

}  // namespace

std::string print_loop_body(const EmissionContext& context, const Program& program) {
  NameSet used;
  return print_body_of(context, program, used);
}

std::vector<GeneratedFile> print_loops(const Contents& contents) {
  const EmissionContext& context = contents.context;
  std::vector<NameSet> used;
  for (const Program& program : contents.all) {
    if (program.loops) print_body_of(context, program, used.emplace_back());
  }
  NameSet of_tables;
  const GeneratedFile tables = print_tables(context, contents.all, of_tables);
  for (NameSet& names : used) names.insert(of_tables.begin(), of_tables.end());
  return {tables, {header_name(context, "link_functions"), adapt_loops(contents, used)}};
}

}  // namespace treeline
