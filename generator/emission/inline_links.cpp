#include "emission/inline_links.hpp"

#include <regex>

#include "target/target.hpp"

namespace treeline {

std::string settle_inlining(const EmissionContext& context, std::string_view header) {
  static const std::regex definition(
      "(?://[^\\n]*\\n)*#if defined\\(__GNUC__\\)\\n#define TREELINE_LINK_INLINE [^\\n]*\\n"
      "#else\\n[^\\n]*\\n#endif\\n\\n?");
  static const std::regex use("\\bTREELINE_LINK_INLINE\\b");
  const std::string text(header);
  if (!context.misra && !emulates(*find_target(context.target), context.single_precision ? 4 : 8)) {
    return text;
  }
  return std::regex_replace(std::regex_replace(text, definition, ""), use, "inline");
}

}  // namespace treeline
