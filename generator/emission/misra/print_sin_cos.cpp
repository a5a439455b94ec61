#include "emission/misra/print_sin_cos.hpp"

#include <fmt/format.h>

#include <map>
#include <sstream>

#include "emission/c/lift_steps.hpp"
#include "emission/c_family_syntax.hpp"
#include "emission/cpp/templates.hpp"
#include "emission/fill_template.hpp"
#include "emission/misra/templates.hpp"

namespace treeline::misra {
namespace {

/// The lines of the constants that need no bits.
std::string select_constants(const std::string& lifted) {
  std::istringstream lines(lifted);
  std::string constants;
  for (std::string line; std::getline(lines, line);) {
    const bool kept = line.find(" kRoundingShift ") != std::string::npos ||
                      line.find(" kTwoOverPi ") != std::string::npos;
    if (kept) constants += line + "\n";
  }
  return constants;
}

std::string print_head(const EmissionContext& context, bool is_c, const char* real) {
  return is_c ? fmt::format(
                    "static inline void {0}_sin_cos_of({1} angle, {1}* sine_of_x,\n"
                    "                                  {1}* cosine_of_x) {{",
                    context.name, real)
              : fmt::format(
                    "inline void sin_cos({0} angle, {0}& sine_of_angle, {0}& cosine_of_angle) "
                    "noexcept {{",
                    real);
}

std::string print_turn_head(const EmissionContext& context, bool is_c, const char* real) {
  return is_c ? fmt::format(
                    "static inline void {0}_turn_by_quarters(int32_t place, {1} sine, {1} cosine,\n"
                    "                                        {1}* sine_of_x, {1}* cosine_of_x) {{",
                    context.name, real)
              : fmt::format(
                    "inline void turn_by_quarters(int32_t place, {0} sine, {0} cosine,\n"
                    "                             {0}& sine_of_angle, {0}& cosine_of_angle) "
                    "noexcept {{",
                    real);
}

std::string print_steps(const EmissionContext& context, bool is_c) {
  const bool single = context.single_precision;
  const char* const real = number_type(context);
  const auto number = [&](const char* digits) { return number_literal(context, digits); };
  const auto lifted = c::lift_steps(cpp::templates::kSinCos, context.name, single);
  return fill_template(
      templates::kSinCosSteps,
      {{"accurate", single ? "4000" : "1e5"},
       {"largest", single ? "2^20" : "2^32"},
       {"largest_angle", number(single ? "0x1p+20" : "0x1p+32")},
       {"turn_head", print_turn_head(context, is_c, real)},
       {"call_turn",
        is_c ? fmt::format("{}_turn_by_quarters(place, sine, cosine, sine_of_x, cosine_of_x);",
                           context.name)
             : "turn_by_quarters(place, sine, cosine, sine_of_angle, cosine_of_angle);"},
       {"head", print_head(context, is_c, real)},
       {"constants", select_constants(lifted.at("constants"))},
       {"subtract_quarters", lifted.at("subtract_quarters")},
       {"sin_cos_remainder", lifted.at("sin_cos_remainder")},
       {"real", real},
       {"rest", single ? "excess" : "tail"},
       {"to_index", is_c ? "(int32_t)" : "static_cast<int32_t>"},
       // Static: of a table on the stack compilers make a call of memcpy.
       {"table", is_c ? "static const" : "static constexpr"},
       {"sine_of_angle", is_c ? "*sine_of_x" : "sine_of_angle"},
       {"cosine_of_angle", is_c ? "*cosine_of_x" : "cosine_of_angle"},
       {"zero", number("0.0")},
       {"fourth", number("0.25")},
       {"one", number("1.0")},
       {"two", number("2.0")},
       {"four", number("4.0")},
       {"minus", number("-1.0")}});
}

}  // namespace

std::string print_sin_cos(const EmissionContext& context) {
  const bool is_c = context.language == Language::c;
  return fill_template(is_c ? templates::kSinCosC : templates::kSinCosCpp,
                       {{"name", context.name},
                        {"real", number_type(context)},
                        {"steps", print_steps(context, is_c)}});
}

}  // namespace treeline::misra
