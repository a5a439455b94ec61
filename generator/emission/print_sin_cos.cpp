#include <fmt/format.h>

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "emission/adapt.hpp"
#include "emission/backend.hpp"
#include "emission/c_family_syntax.hpp"
#include "emission/core_headers.hpp"
#include "emission/descriptions.hpp"
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
      {"TL_ACCURATE_ANGLE", describe_sines(single, context.misra).accurate},
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

/// A text without its comments on declarations.
std::string without_comments(const std::string& text) {
  std::string code;
  for (std::size_t at = 0, end = 0; at < text.size(); at = end) {
    end = text.find('\n', at) + 1;
    if (text.compare(at, 3, "///") != 0) code += text.substr(at, end - at);
  }
  return code;
}

Adaptation make_group_adaptation(const EmissionContext& context) {
  Adaptation own = make_sine_adaptation(context);
  own.words["TL_INLINE"] = name_in_capitals(context) + "_SINES_INLINE";
  return own;
}

/// The steps of so many angles side by side; `name` is that of their type.
std::string print_steps_in_lanes(const EmissionContext& context, const char* name,
                                 const char* lanes) {
  Adaptation own = make_group_adaptation(context);
  own.part = name;
  own.words["TlAngle"] = context.name + "_" + name;
  own.words.erase("TlAngleBits");  // a type of its own, too
  own.words["TL_LANES"] = lanes;
  std::vector<std::string_view> headers = list_steps(context);
  headers.front() = templates::kLaneBits;  // instead of the bits of one number
  headers.push_back(templates::kSinCosOfLanes);
  std::string text;
  for (const std::string_view header : headers) {
    text += (text.empty() ? "" : "\n") + without_comments(adapt_declarations(header, own));
  }
  return text;
}

/// The loop of one angle after the other and, where there may be lanes, groups of them.
std::string print_for_arrays(const EmissionContext& context, Adaptation own) {
  const bool grouped = context.language == Language::c && !context.misra && context.lanes > 1;
  if (grouped) own.words["tl_sin_cos"] = context.name + "_sin_cos_of_each";
  const std::string each =
      adapt(join_headers(list_steps(context), templates::kSinCosOfArrays), own);
  if (!grouped) return each;
  const char* const wide = context.single_precision ? "__AVX__" : "__AVX512F__";
  return each + "\n" +
         fill_template(templates::kSinCosInGroups,
                       {{"name", context.name},
                        {"NAME", name_in_capitals(context)},
                        {"real", number_type(context)},
                        {"wide", fmt::format("defined({})", wide)},
                        {"groups", adapt_declarations(templates::kGroupsOfAngles,
                                                      make_group_adaptation(context))},
                        {"fours", print_steps_in_lanes(context, "fours", "4")},
                        {"eights", print_steps_in_lanes(context, "eights", "8")}});
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
  return {name, print_for_arrays(context, own)};
}

std::string print_sines_in_lanes() {
  const std::pair<std::string_view, std::string_view> headers[] = {
      {"quarter_turns", templates::kQuarterTurns},
      {"remainder_in_double", templates::kRemainderInDouble},
      {"remainder_in_float", templates::kRemainderInFloat},
      {"sin_cos_in_double", templates::kSinCosInDouble},
      {"sin_cos_in_float", templates::kSinCosInFloat},
      {"groups_of_angles", templates::kGroupsOfAngles}};
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
