#include <fmt/format.h>

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "emission/adapt.hpp"
#include "emission/backend.hpp"
#include "emission/c_family_syntax.hpp"
#include "emission/core_headers.hpp"
#include "emission/emitted_text.hpp"
#include "emission/print_files.hpp"
#include "emission/templates.hpp"

namespace treeline {
namespace {

/// What angle_format.h lists, and the numbers of tables of quarter turns.
Adaptation make_sine_adaptation(const EmissionContext& context) {
  const bool single = context.single_precision;
  Adaptation own = make_adaptation(context, header_name(context, context.name));
  add_literals(context,
               {{"TL_TWO_OVER_PI", single ? "0x1.45f306p-1" : "0.6366197723675814"},
                {"TL_ROUNDING_SHIFT", single ? "12582912.0" : "6755399441055744.0"},
                {"TL_LARGEST_ANGLE", single ? "0x1p+20" : "0x1p+32"},
                {"TL_FOURTH", "0.25"},
                {"TL_TWO", "2.0"},
                {"TL_FOUR", "4.0"}},
               own);
  add_number_format(context, own);
  const std::map<std::string, std::string> words = {
      {"TlAngle", number_type(context)},
      {"TlAngleBits", own.words["TlBits"]},
      {"TL_LARGEST_EXPONENT", single ? "20" : "32"},
      {"TL_ACCURATE_ANGLE", single ? "4000" : "1e5"},
      {"TL_AS_INDEX", fmt::format(fmt::runtime(backend_of(context.language).cast), "int32_t")}};
  own.words.insert(words.begin(), words.end());
  return own;
}

/// The steps by the bits of numbers, or by tables, in the order in which they are declared.
std::vector<std::string_view> list_steps(const EmissionContext& context) {
  const bool single = context.single_precision;
  const std::string_view remainder =
      single ? templates::kRemainderInFloat : templates::kRemainderInDouble;
  if (context.misra) return {remainder, templates::kSinCosByTables};
  return {templates::kNumberBits, templates::kQuarterTurns, remainder,
          single ? templates::kSinCosInFloat : templates::kSinCosInDouble};
}

/// C++ has references to arrays around the steps.
std::string print_for_references(const EmissionContext& context, const Adaptation& own) {
  std::string steps;
  for (const std::string_view header : list_steps(context)) {
    steps += (steps.empty() ? "" : "\n") + adapt_declarations(header, own);
  }
  return fill_template(templates::kSinCosOfReferences,
                       {{"name", context.name},
                        {"real", number_type(context)},
                        {"accurate", own.words.at("TL_ACCURATE_ANGLE")},
                        {"largest", "2^" + own.words.at("TL_LARGEST_EXPONENT")},
                        {"steps", steps}});
}

}  // namespace

GeneratedFile print_sin_cos(const EmissionContext& context) {
  const Adaptation own = make_sine_adaptation(context);
  const std::string name = header_name(context, "sin_cos");
  if (backend_of(context.language).has_references)
    return {name, print_for_references(context, own)};
  return {name, adapt(join_headers(list_steps(context), templates::kSinCosOfArrays), own)};
}

std::string print_sines_in_lanes() {
  const std::pair<std::string_view, std::string_view> headers[] = {
      {"quarter_turns", templates::kQuarterTurns},
      {"remainder_in_double", templates::kRemainderInDouble},
      {"remainder_in_float", templates::kRemainderInFloat},
      {"sin_cos_in_double", templates::kSinCosInDouble},
      {"sin_cos_in_float", templates::kSinCosInFloat}};
  // `real` stays: there it is the number type of lanes.
  const Adaptation own{Language::cpp, "", "", {{"TL_INLINE", "TREELINE_STEP"}}};
  std::string text(core_headers::kSinCos);
  for (const auto& [name, header] : headers) {
    const std::string line = fmt::format("#include \"emitted/{}.h\"\n", name);
    const std::size_t at = text.find(line);
    const bool is_last = !std::string_view(text).substr(at + line.size()).starts_with("#include");
    text.replace(at, line.size(), adapt_declarations(header, own) + (is_last ? "" : "\n"));
  }
  return adapt_words(text, own);
}

}  // namespace treeline
