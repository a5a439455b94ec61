#include "emission/misra/print_damped_runtime.hpp"

#include <fmt/format.h>

#include "emission/c_family_syntax.hpp"
#include "emission/fill_template.hpp"
#include "emission/misra/templates.hpp"
#include "emission/print_damped_steps.hpp"
#include "emission/wrap_line.hpp"

namespace treeline::misra {
namespace {

/// Exponents of four, the largest twice: they add up to that of the smallest number.
std::vector<int> list_exponents(bool single) {
  const int largest = single ? 32 : 256;
  std::vector<int> exponents = {largest};
  for (int exponent = largest; exponent > 0; exponent /= 2) exponents.push_back(exponent);
  return exponents;
}

/// `static constexpr double powers[10] = {0x1p+512, ...};` with two to `factor` times each
/// exponent: not on the stack, where compilers would copy it by memcpy.
std::string print_powers(const EmissionContext& context, const char* name, int factor) {
  std::string list;
  const std::vector<int> exponents = list_exponents(context.single_precision);
  for (const int exponent : exponents) {
    list += list.empty() ? "" : ", ";
    list += number_literal(context, fmt::format("0x1p{:+}", factor * exponent).c_str());
  }
  return wrap_line(
      fmt::format("{} {} {}[{}] = {{{}}};",
                  context.language == Language::c ? "static const" : "static constexpr",
                  number_type(context), name, exponents.size(), list),
      2);
}

std::string print_root_steps(const EmissionContext& context) {
  const bool single = context.single_precision;
  const bool is_c = context.language == Language::c;
  const std::string bits = fmt::format("uint{}_t", single ? 32 : 64);
  const char* const real = number_type(context);
  const auto cast = [&](const std::string& type) {
    return is_c ? fmt::format("({})", type) : fmt::format("static_cast<{}>", type);
  };
  auto words = list_phrases(context);
  words.insert(
      {{"powers", print_powers(context, "powers", 2) + print_powers(context, "inverse_powers", -2) +
                      print_powers(context, "roots", 1) +
                      print_powers(context, "inverse_roots", -1)},
       {"steps", std::to_string(list_exponents(single).size())},
       {"real", real},
       {"bits", bits},
       {"to_bits", cast(bits)},
       {"to_real", cast(real)},
       {"fraction", single ? "23" : "52"},
       {"heron_steps", single ? "3" : "4"},
       {"third", number_literal(context, single ? "0x1.555556p-2" : "0x1.5555555555555p-2")},
       {"half", number_literal(context, "0.5")},
       {"two", number_literal(context, "2.0")},
       {"unit", number_literal(context, single ? "0x1p+23" : "0x1p+52")},
       {"inverse_unit", number_literal(context, single ? "0x1p-23" : "0x1p-52")},
       {"largest", number_literal(context, single ? "0x1.fffffep+127" : "0x1.fffffffffffffp+1023")},
       {"zero", number_literal(context, "0.0")},
       {"one", number_literal(context, "1.0")},
       {"four", number_literal(context, "4.0")}});
  return fill_template(templates::kSquareRootSteps, words);
}

}  // namespace

GeneratedFile print_square_root(const EmissionContext& context) {
  const bool is_c = context.language == Language::c;
  return {is_c ? "square_root.h" : "square_root.hpp",
          fill_template(is_c ? templates::kSquareRootC : templates::kSquareRootCpp,
                        {{"name", context.name}, {"steps", print_root_steps(context)}})};
}

std::vector<GeneratedFile> print_damped_runtime(const EmissionContext& context) {
  return {{"damped_solve.hpp", fill_template(templates::kDampedSolve,
                                             {{"name", context.name},
                                              {"real", number_type(context)},
                                              {"rows", std::to_string(context.task_rows)},
                                              {"velocities", std::to_string(context.velocities)},
                                              {"steps", print_damped_steps(context)}})},
          print_square_root(context)};
}

}  // namespace treeline::misra
