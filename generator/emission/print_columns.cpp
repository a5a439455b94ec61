#include "emission/print_columns.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "core/emitted_columns.hpp"
#include "emission/adapt.hpp"
#include "emission/backend.hpp"
#include "emission/print_constants.hpp"
#include "emission/templates.hpp"
#include "emission/wrap_line.hpp"
#include "program/column_solve.hpp"

namespace treeline {
namespace {

Adaptation make_column_adaptation(const EmissionContext& context) {
  Adaptation own = make_adaptation(context, header_name(context, context.name));
  return own;
}

std::string print_column_sizes(const EmissionContext& context, const Adaptation& own) {
  const Constant sizes[] = {{"STRIDE", core::column_stride(context.velocities),
                             "of rows that hold three rows of matrices"}};
  return print_sizes(
      context.name, own,
      "#pragma once\n// Sizes of arrays that solve_columns.h computes in.\n\n#include "
      "<stdint.h>\n\n#include \"TL_CONTRACT.h\"\n\nTL_CONSTANTS",
      sizes);
}

/// A name of runtime/emitted as code outside of its headers writes it.
std::string in_detail(const EmissionContext& context, std::string_view word) {
  const char* const scope = backend_of(context.language).has_namespaces ? "detail::" : "";
  return scope + adapt_words(word, make_column_adaptation(context));
}

/// Arrays have at least one number.
std::string print_table(const std::string& name, std::vector<std::int16_t> values) {
  if (values.empty()) values.push_back(0);
  return wrap_line(fmt::format("static const int16_t {}[{}] = {{{}}};", name, values.size(),
                               fmt::join(values, ", ")),
                   2);
}

std::string print_sums(const EmissionContext& context, const std::string& name,
                       const RowSums& sums) {
  return print_table(name + "_ends", sums.ends) + print_table(name + "_entries", sums.entries) +
         wrap_line(fmt::format("static const {0} {1} = {{&{1}_ends[0], &{1}_entries[0]}};",
                               in_detail(context, "TlRowSums"), name),
                   2);
}

bool is_solved(const Program& program) {
  return program.columns != nullptr;
}

}  // namespace

std::string add_column_solve(const EmissionContext& context, const Program& program,
                             const std::string& lines) {
  if (!is_solved(program)) return lines;
  const ColumnSolve& columns = *program.columns;
  const std::string real =
      backend_of(context.language).has_namespaces ? "Real" : number_type(context);
  std::string arrays = print_sums(context, "above", columns.above) +
                       print_sums(context, "below", columns.below) +
                       fmt::format("  {} rows[{}];\n", real, columns.count_work());
  for (const Result& result : columns.lines.results) {
    if (!is_for_columns(result)) continue;
    arrays += fmt::format("  {} {}[{}];\n", real, result.argument.name, result.values.size());
  }
  std::string list =
      fmt::format("&above, &below, &{}[0], &{}[0], &rows[0]", kColumnFactors, kColumnPivots);
  for (const Argument& result : columns.results) list += fmt::format(", &{}[0]", result.name);
  return arrays + "\n" + lines + "\n" +
         wrap_line(fmt::format("{}({});", in_detail(context, "tl_solve_columns"), list), 2);
}

std::string print_column_include(const EmissionContext& context, const Program& program) {
  if (!is_solved(program)) return {};
  return fmt::format("#include \"{}\"\n", header_name(context, "solve_columns"));
}

bool wants_columns(const Contents& contents) {
  return std::any_of(contents.all.begin(), contents.all.end(), is_solved);
}

std::vector<GeneratedFile> print_column_headers(const Contents& contents) {
  const EmissionContext& context = contents.context;
  const Adaptation own = make_column_adaptation(context);
  return {{header_name(context, "column_sizes"), print_column_sizes(context, own)},
          {header_name(context, "solve_columns"), adapt(templates::kSolveColumns, own)}};
}

}  // namespace treeline
