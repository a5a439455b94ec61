#include "drive/page.hpp"

#ifdef TREELINE_PAGE
// The assembler copies the files as they are: as string literals they would take a compiler long.
#define TREELINE_CARRY(name, file)                                                 \
  __asm__(".section .rodata\n.global treeline_page_" name "\ntreeline_page_" name  \
          ":\n.incbin \"" TREELINE_PAGE "/" file "\"\n.global treeline_page_" name \
          "_end\ntreeline_page_" name "_end:\n.byte 0\n.previous\n")

TREELINE_CARRY("html", "index.html");
TREELINE_CARRY("script", "page.js");
TREELINE_CARRY("style", "page.css");

extern "C" {  // NOLINTBEGIN(readability-identifier-naming): symbols of the text above
extern const char treeline_page_html[], treeline_page_html_end[];
extern const char treeline_page_script[], treeline_page_script_end[];
extern const char treeline_page_style[], treeline_page_style_end[];
}  // NOLINTEND(readability-identifier-naming)

namespace treeline::drive {

Page carried_page() {
  const auto text = [](const char* begin, const char* end) {
    return std::string_view(begin, static_cast<std::size_t>(end - begin));
  };
  return {text(treeline_page_html, treeline_page_html_end),
          text(treeline_page_script, treeline_page_script_end),
          text(treeline_page_style, treeline_page_style_end)};
}

}  // namespace treeline::drive
#else
namespace treeline::drive {

Page carried_page() {
  return {};
}

}  // namespace treeline::drive
#endif
