#include "emission/c/print_runtime.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "emission/c/print_batch.hpp"
#include "emission/c/print_loops.hpp"
#include "emission/c/templates.hpp"
#include "emission/describe_program.hpp"
#include "emission/fill_template.hpp"
#include "emission/list_sources.hpp"
#include "emission/print_columns.hpp"
#include "emission/print_damped_headers.hpp"
#include "emission/print_limit_headers.hpp"
#include "emission/print_sin_cos.hpp"
#include "emission/print_square_root.hpp"
#include "program/column_solve.hpp"

namespace treeline::c {
namespace {

/// `a, b, c, d`, or the same in parentheses: `(a), (b)`.
std::string list_letters(std::size_t first, std::size_t count, bool in_parentheses) {
  std::string list;
  for (std::size_t i = first; i < first + count; ++i) {
    const std::string letter(1, static_cast<char>('a' + i));
    list += (list.empty() ? "" : ", ") + (in_parentheses ? "(" + letter + ")" : letter);
  }
  return list;
}

/// Two, four and eight lanes, as many as the functions have at most.
std::string print_lanes(const EmissionContext& context, std::span<const Program> programs) {
  std::size_t most = 0;
  for (const Program& program : programs) {
    for (const LanePack& pack : printed_lines(program).packs) most = std::max(most, pack.size());
  }
  std::string types;
  for (std::size_t count = 2; count <= most; count *= 2) {
    types += fill_template(
        templates::kLanesOfCount,
        {{"name", context.name},
         {"NAME", name_in_capitals(context)},
         {"real", number_type(context)},
         {"zero", number_literal(context, "0.0")},
         {"count", std::to_string(count)},
         {"half", std::to_string(count / 2)},
         {"bytes", std::to_string(count * static_cast<std::size_t>(number_bytes(context)))},
         {"all", list_letters(0, count, false)},
         {"all_in_parentheses", list_letters(0, count, true)},
         {"low", list_letters(0, count / 2, false)},
         {"high", list_letters(count / 2, count / 2, false)}});
  }
  return fill_template(templates::kLanes, {{"name", context.name},
                                           {"NAME", name_in_capitals(context)},
                                           {"real", number_type(context)},
                                           {"types", types}});
}

}  // namespace

std::vector<GeneratedFile> print_runtime(const EmissionContext& context,
                                         std::span<const Program> asked,
                                         std::span<const Program> batch) {
  std::vector<GeneratedFile> files;
  const std::vector<Program> programs = list_sources(context, asked);
  const bool controlled = context.controller != nullptr;
  const bool damped = !context.effective_mass_limits.empty();
  const bool limited = context.limits.has_value();
  if (damped) files = print_damped_headers(context);
  if (limited) {
    for (GeneratedFile& file : print_limit_headers(context)) files.push_back(std::move(file));
  }
  if (damped || limited || controlled) {
    files.push_back(print_square_root(context));
  }
  std::vector<GeneratedFile> loops = print_loop_headers(context, programs);
  if (damped || limited || controlled || !loops.empty() ||
      std::any_of(batch.begin(), batch.end(), uses_trigonometry) ||
      std::any_of(programs.begin(), programs.end(), uses_trigonometry)) {
    files.push_back(print_sin_cos(context));
  }
  if (std::any_of(programs.begin(), programs.end(), uses_lanes)) {
    files.push_back({"lanes.h", print_lanes(context, programs)});
  }
  for (GeneratedFile& file : print_batch_runtime(context, batch)) files.push_back(std::move(file));
  for (GeneratedFile& file : loops) files.push_back(std::move(file));
  for (GeneratedFile& file : print_column_headers(context, programs)) {
    files.push_back(std::move(file));
  }
  return files;
}

}  // namespace treeline::c
