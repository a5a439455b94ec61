#include <algorithm>
#include <string>

#include "emission/c/print_files.hpp"
#include "emission/c/templates.hpp"
#include "emission/c_family_syntax.hpp"
#include "emission/emitted_text.hpp"
#include "program/ending.hpp"

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

}  // namespace

std::vector<GeneratedFile> print_lane_types(const Contents& contents) {
  const EmissionContext& context = contents.context;
  std::size_t most = 0;
  for (const Program& program : contents.all) {
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
  return {{"lanes.h", fill_template(templates::kLanes, {{"name", context.name},
                                                        {"NAME", name_in_capitals(context)},
                                                        {"real", number_type(context)},
                                                        {"types", types}})}};
}

}  // namespace treeline::c
