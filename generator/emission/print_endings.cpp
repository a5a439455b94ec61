#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>

#include "core/in_eights.hpp"
#include "emission/adapt.hpp"
#include "emission/backend.hpp"
#include "emission/body_steps.hpp"
#include "emission/c_family_syntax.hpp"
#include "emission/emitted_text.hpp"
#include "emission/print_files.hpp"
#include "emission/templates.hpp"
#include "program/ending.hpp"

namespace treeline {
namespace {

struct EmittedHeader {
  const char* name;
  const std::string_view* text;
};

constexpr EmittedHeader kSolveColumns{"solve_columns", &templates::kSolveColumns};
constexpr EmittedHeader kCommonFrame{"common_frame", &templates::kCommonFrame};
constexpr EmittedHeader kAccelerationDerivatives{"acceleration_derivatives",
                                                 &templates::kAccelerationDerivatives};
constexpr EmittedHeader kForceDerivatives{"force_derivatives", &templates::kForceDerivatives};

/// A routine's name, and its header with those that it includes.
struct RoutineText {
  Routine routine;
  const char* call;
  std::vector<EmittedHeader> headers;
};

const std::vector<RoutineText>& list_routines() {
  static const std::vector<RoutineText> routines{
      {Routine::solve_columns, "tl_solve_columns", {kSolveColumns}},
      {Routine::mass_matrix, "tl_mass_in_common_frame", {kCommonFrame}},
      {Routine::force_derivatives, "tl_force_derivatives", {kForceDerivatives, kCommonFrame}},
      {Routine::acceleration_derivatives,
       "tl_acceleration_derivatives",
       {kAccelerationDerivatives, kForceDerivatives, kCommonFrame, kSolveColumns}}};
  return routines;
}

const RoutineText& text_of(const Ending& ending) {
  const auto& routines = list_routines();
  return *std::find_if(routines.begin(), routines.end(),
                       [&](const RoutineText& row) { return row.routine == ending.routine; });
}

Adaptation make_ending_adaptation(const EmissionContext& context) {
  return make_adaptation(context, header_name(context, context.name));
}

bool has_ending(const Program& program) {
  return program.ending != nullptr;
}

std::string print_ending_sizes(const Contents& contents, const Adaptation& own) {
  const EmissionContext& context = contents.context;
  bool floats = false;
  int path = 0;
  for (const Program& program : contents.all) {
    if (!has_ending(program)) continue;
    floats = floats || program.ending->floats;
    path = std::max(path, program.ending->path);
  }
  const Constant sizes[] = {
      {"PLACES", core::in_eights(context.velocities), "of freedoms side by side"},
      {"PATH", path, "of rows that have what carries a freedom, and itself"},
      {"FLOATS", floats ? 1 : 0, "whether the base floats"}};
  return print_sizes(
      context.name, own,
      "#pragma once\n// Sizes of arrays that functions end with.\n\n#include <stddef.h>\n#include "
      "<stdint.h>\n\n#include \"TL_CONTRACT.h\"\n\nTL_CONSTANTS",
      sizes);
}

/// A name of runtime/emitted as code outside of its headers writes it.
std::string in_detail(const EmissionContext& context, std::string_view word) {
  return std::string(backend_of(context.language).details) +
         adapt_words(word, make_ending_adaptation(context));
}

std::string real_of(const EmissionContext& context) {
  return backend_of(context.language).has_namespaces ? "Real" : number_type(context);
}

std::string print_ending_table(const EmissionContext& context, const Table& table) {
  std::vector<std::string> texts;
  std::string type = "int16_t";
  if (const auto* places = std::get_if<std::vector<std::int16_t>>(&table.values)) {
    for (const std::int16_t place : *places) texts.push_back(std::to_string(place));
  } else {
    type = real_of(context);
    const Syntax syntax = backend_of(context.language).syntax(context);
    for (const double number : std::get<std::vector<double>>(table.values)) {
      texts.push_back(signed_literal(syntax, number));
    }
  }
  return print_table(fmt::format("static const {} {}", type, table.name), std::move(texts), 2);
}

std::string print_array(const std::string& real, const std::string& name, std::size_t size) {
  return fmt::format("  TREELINE_ALIGNED {} {}[{}];\n", real, name, size);
}

/// The headers of all routines, once each.
std::map<std::string_view, std::string_view> list_headers(const Contents& contents) {
  std::map<std::string_view, std::string_view> headers;
  for (const Program& program : contents.all) {
    if (!has_ending(program)) continue;
    for (const auto& [name, text] : text_of(*program.ending).headers) headers[name] = *text;
  }
  return headers;
}

}  // namespace

std::string add_ending(const EmissionContext& context, const Program& program,
                       const std::string& lines) {
  if (!has_ending(program)) return lines;
  const Ending& ending = *program.ending;
  const std::string real = real_of(context);
  const RoutineText& routine = text_of(ending);
  std::string arrays = fmt::format("  // Constants of {}, which tells what they are.\n",
                                   header_name(context, routine.headers.front().name));
  std::vector<std::string> list;
  const auto pass = [&list](const std::string& name) { list.push_back("&" + name + "[0]"); };
  for (const Table& table : ending.tables) {
    arrays += print_ending_table(context, table);
    pass(table.name);
  }
  for (const Result& array : ending.lines.results) {
    if (!is_only_read(ending, array)) continue;
    arrays += print_array(real, array.argument.name, array.values.size());
    pass(array.argument.name);
  }
  if (ending.work > 0) {
    arrays += print_array(real, "work", ending.work);
    pass("work");
  }
  for (const Argument& result : ending.results) pass(result.name);
  const std::string call = in_detail(context, routine.call);
  return arrays + "\n" + lines + "\n" +
         wrap_line(fmt::format("{}({});", call, fmt::join(list, ", ")), 2);
}

std::string print_ending_include(const EmissionContext& context, const Program& program) {
  if (!has_ending(program)) return {};
  return fmt::format("#include \"{}\"\n",
                     header_name(context, text_of(*program.ending).headers.front().name));
}

bool wants_endings(const Contents& contents) {
  return std::any_of(contents.all.begin(), contents.all.end(), has_ending);
}

std::vector<GeneratedFile> print_ending_headers(const Contents& contents) {
  const EmissionContext& context = contents.context;
  const Adaptation own = make_ending_adaptation(context);
  std::vector<GeneratedFile> files{
      {header_name(context, "ending_sizes"), print_ending_sizes(contents, own)}};
  for (const auto& [name, text] : list_headers(contents)) {
    files.push_back({header_name(context, std::string(name)), adapt(text, own)});
  }
  return files;
}

}  // namespace treeline
