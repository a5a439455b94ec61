#include <fmt/format.h>

#include <string>
#include <vector>

#include "emission/adapt.hpp"
#include "emission/backend.hpp"
#include "emission/c_family_syntax.hpp"
#include "emission/print_files.hpp"
#include "emission/templates.hpp"

namespace treeline {
namespace {

/// Exponents of four, the largest twice: they add up to that of the smallest number.
std::vector<int> list_exponents(bool single) {
  const int largest = single ? 32 : 256;
  std::vector<int> exponents = {largest};
  for (int exponent = largest; exponent > 0; exponent /= 2) exponents.push_back(exponent);
  return exponents;
}

/// `0x1p+512, 0x1p+512, ...`: two to `factor` times each exponent, five on a line.
std::string list_powers(const EmissionContext& context, int factor) {
  std::string list;
  int count = 0;
  for (const int exponent : list_exponents(context.single_precision)) {
    if (count > 0) list += count % 5 == 0 ? ",\n      " : ", ";
    list += number_literal(context, fmt::format("0x1p{:+}", factor * exponent).c_str());
    ++count;
  }
  return list;
}

/// Names of the macros that say whether the target has an instruction for the root.
void add_macros(const EmissionContext& context, Adaptation& own) {
  const std::string macros = fmt::format("TREELINE_{}_ROOT_OF_", name_in_capitals(context));
  own.words["TL_ROOT_OF_FLOAT"] = macros + "FLOAT";
  own.words["TL_ROOT_OF_DOUBLE"] = macros + "DOUBLE";
  own.words["TL_ROOT_INSTRUCTION"] = macros + (context.single_precision ? "FLOAT" : "DOUBLE");
}

/// The numbers of Heron's steps.
void add_steps(const EmissionContext& context, Adaptation& own) {
  const bool single = context.single_precision;
  add_literals(context,
               {{"TL_HALF", "0.5"},
                {"TL_TWO", "2.0"},
                {"TL_FOUR", "4.0"},
                {"TL_THIRD", single ? "0x1.555556p-2" : "0x1.5555555555555p-2"},
                {"TL_UNIT", single ? "0x1p+23" : "0x1p+52"},
                {"TL_INVERSE_UNIT", single ? "0x1p-23" : "0x1p-52"},
                {"TL_LARGEST", single ? "0x1.fffffep+127" : "0x1.fffffffffffffp+1023"}},
               own);
  own.words["TL_HERON_STEPS"] = single ? "3" : "4";
  own.words["TL_POWER_COUNT"] = std::to_string(list_exponents(single).size());
  own.words["TL_POWERS"] = list_powers(context, 2);
  own.words["TL_INVERSE_POWERS"] = list_powers(context, -2);
  own.words["TL_ROOTS"] = list_powers(context, 1);
  own.words["TL_INVERSE_ROOTS"] = list_powers(context, -1);
  const std::string_view cast = backend_of(context.language).cast;
  own.words["TL_AS_BITS"] = fmt::format(fmt::runtime(cast), own.words["TlBits"]);
  own.words["TL_AS_REAL"] = fmt::format(fmt::runtime(cast), number_type(context));
}

}  // namespace

GeneratedFile print_square_root(const EmissionContext& context) {
  Adaptation own = make_adaptation(context, header_name(context, context.name));
  add_number_format(context, own);
  add_macros(context, own);
  if (context.misra) add_steps(context, own);
  return {header_name(context, "square_root"),
          adapt(context.misra ? templates::kSquareRootBySteps : templates::kSquareRoot, own)};
}

}  // namespace treeline
