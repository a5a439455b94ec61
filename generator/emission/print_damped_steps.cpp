#include "emission/print_damped_steps.hpp"

#include <fmt/format.h>

#include "core/symmetric_eigen.hpp"
#include "emission/c/templates.hpp"
#include "emission/c_family_syntax.hpp"
#include "emission/fill_template.hpp"

namespace treeline {
namespace {

using Phrases = std::map<std::string, std::string>;

int count_sweeps(const EmissionContext& context) {
  return context.single_precision ? core::ql_sweeps<float>(context.task_rows)
                                  : core::ql_sweeps<double>(context.task_rows);
}

/// Constants, the struct of rotations, and arguments that are arrays: pointers in C.
Phrases list_phrases_of_c(const EmissionContext& context) {
  const std::string& name = context.name;
  return {
      {"rows_constant", fmt::format("enum {{ {}_rows = {} }};", name, context.task_rows)},
      {"local_rows", fmt::format("enum {{ N = {}_rows }};", name)},
      {"sweeps_constant", fmt::format("enum {{ {}_sweeps = {} }};", name, count_sweeps(context))},
      {"sweeps_count", name + "_sweeps"},
      {"begin_turns", "typedef struct {"},
      {"end_turns", fmt::format("}} {}_turns;", name)},
      {"turns_type", name + "_turns"},
      {"turns", "turns->"},
      {"array", "* "},
      {"of_matrix", ""},
      {"of_vector", ""},
      {"of_rotations", ""}};
}

/// The same in C++: references to arrays.
Phrases list_phrases_of_cpp(const EmissionContext& context) {
  const int rows = context.task_rows;
  const int rotations = (2 * count_sweeps(context) * (rows - 1)) + 1;
  return {{"rows_constant", fmt::format("inline constexpr int32_t kRows = {};", rows)},
          {"local_rows", "constexpr int32_t N = kRows;"},
          {"sweeps_constant",
           fmt::format("inline constexpr int32_t kSweeps = {};", count_sweeps(context))},
          {"sweeps_count", "kSweeps"},
          {"begin_turns", "struct Turns {"},
          {"end_turns", "};"},
          {"turns_type", "Turns"},
          {"turns", "turns."},
          {"array", " (&"},
          {"of_matrix", fmt::format(")[{}]", rows * rows)},
          {"of_vector", fmt::format(")[{}]", rows)},
          {"of_rotations", fmt::format(")[{}]", rotations)}};
}

}  // namespace

std::map<std::string, std::string> list_phrases(const EmissionContext& context) {
  if (context.language == Language::c) {
    return {{"inline", "static inline"},
            {"bool", "bool"},
            {"int", "int"},
            {"prefix", context.name + "_"},
            {"ref", "*"},
            {"value", "*"},
            {"address", "&"},
            {"noexcept", ""}};
  }
  return {{"inline", "inline"}, {"bool", "bool"}, {"int", "int32_t"}, {"prefix", ""},
          {"ref", "&"},         {"value", ""},    {"address", ""},    {"noexcept", " noexcept"}};
}

std::string print_damped_steps(const EmissionContext& context) {
  const bool single = context.single_precision;
  Phrases words = list_phrases(context);
  words.merge(context.language == Language::c ? list_phrases_of_c(context)
                                              : list_phrases_of_cpp(context));
  words.insert({{"real", number_type(context)},
                {"rows", std::to_string(context.task_rows)},
                {"sweeps", std::to_string(count_sweeps(context))},
                {"resolution", single ? "0x1p-17F" : "0x1p-46"},
                {"negligible", single ? "0x1p-21F" : "0x1p-50"},
                {"lost", single ? "1e-30F" : "1e-280"},
                {"half", number_literal(context, "0.5")},
                {"zero", number_literal(context, "0.0")},
                {"one", number_literal(context, "1.0")},
                {"two", number_literal(context, "2.0")}});
  return fill_template(c::templates::kDampedSteps, words);
}

}  // namespace treeline
