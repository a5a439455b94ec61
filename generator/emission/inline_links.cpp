#include "emission/inline_links.hpp"

#include <algorithm>
#include <regex>

#include "target/target.hpp"

namespace treeline {
namespace {

/// The header without the definition of a macro, and with `instead` where it was used.
std::string replace_macro(const std::string& header, const std::string& macro,
                          const std::string& instead) {
  const std::regex definition("(?://[^\\n]*\\n)*#if [^\\n]*\\n#define " + macro +
                              "[ \\n](?:[^\\n]*\\n)*?#endif\\n\\n?");
  const std::regex use("\\b" + macro + (instead.empty() ? " " : "\\b"));
  return std::regex_replace(std::regex_replace(header, definition, ""), use, instead);
}

}  // namespace

std::string settle_inlining(const EmissionContext& context, std::string_view header,
                            Sharing sharing) {
  std::string text(header);
  if (context.misra || emulates(*find_target(context.target), number_bytes(context))) {
    text = replace_macro(text, "TREELINE_LINK_INLINE", "inline");
  }
  if (context.misra || sharing == Sharing::compilers) {
    text = replace_macro(text, "TREELINE_LINK_SHARED", "");
  }
  return text;
}

}  // namespace treeline
