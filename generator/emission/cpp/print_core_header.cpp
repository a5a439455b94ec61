#include "emission/cpp/print_files.hpp"

namespace treeline::cpp {

std::string print_core_header(const EmissionContext& context, std::string_view header) {
  std::string text(header);
  const auto replace_all = [&text](std::string_view old, const std::string& by) {
    for (std::size_t at = text.find(old); at != std::string::npos;
         at = text.find(old, at + by.size())) {
      text.replace(at, old.size(), by);
    }
  };
  replace_all("treeline::core", context.name + "::detail");
  replace_all("#include \"core/", "#include \"");
  return text;
}

}  // namespace treeline::cpp
