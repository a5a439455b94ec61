#include <fmt/format.h>

#include <string>
#include <string_view>
#include <utility>

#include "core/emitted_damped.hpp"
#include "emission/adapt.hpp"
#include "emission/backend.hpp"
#include "emission/body_steps.hpp"
#include "emission/c_family_syntax.hpp"
#include "emission/print_files.hpp"
#include "emission/templates.hpp"

namespace treeline {
namespace {

Adaptation make_damped_adaptation(const EmissionContext& context) {
  const bool single = context.single_precision;
  Adaptation own = make_adaptation(context, header_name(context, context.name + "_damped"));
  add_literals(context,
               {{"TL_HALF", "0.5"},
                {"TL_TWO", "2.0"},
                {"TL_LOST_SQUARE", single ? "1e-30" : "1e-280"},
                {"TL_NEGLIGIBLE", single ? "0x1p-21" : "0x1p-50"},
                {"TL_UNRESOLVED", single ? "0x1p-17" : "0x1p-46"}},
               own);
  // By `profile: misra` there is no root but that of numbers that are not negative.
  if (context.misra) own.words["tl_square_root"] = adapt_words("tl_root", own);
  return own;
}

std::string print_damped_sizes(const EmissionContext& context, const Adaptation& own) {
  const int rows = context.task_rows;
  const int sweeps =
      context.single_precision ? core::ql_sweeps<float>(rows) : core::ql_sweeps<double>(rows);
  const Constant sizes[] = {{"SWEEPS", sweeps, "of QL, as many as any matrix of this size takes"},
                            {"ROTATIONS", core::count_rotations(rows, sweeps),
                             "numbers that describe them, at least one"}};
  return print_sizes(
      context.name, own,
      "#pragma once\n// Sizes of arrays that damped_solve.h computes in.\n\n#include "
      "<stdbool.h>\n#include <stdint.h>\n\n#include \"TL_CONTRACT.h\"\n\nTL_CONSTANTS",
      sizes);
}

}  // namespace

std::vector<GeneratedFile> print_damped_headers(const EmissionContext& context) {
  const Adaptation own = make_damped_adaptation(context);
  const std::pair<const char*, std::string_view> headers[] = {
      {"damped_solve", templates::kDampedSolve},
      {"ldlt", templates::kLdlt},
      {"symmetric_eigen", templates::kSymmetricEigen}};
  std::vector<GeneratedFile> files = {
      {header_name(context, "damped_sizes"), print_damped_sizes(context, own)}};
  for (const auto& [name, text] : headers) {
    files.push_back({header_name(context, name), adapt(text, own)});
  }
  return files;
}

}  // namespace treeline
