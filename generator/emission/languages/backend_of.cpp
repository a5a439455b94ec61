#include "emission/backend.hpp"
#include "emission/c/backend.hpp"
#include "emission/cpp/backend.hpp"

namespace treeline {

const Backend& backend_of(Language language) {
  static const Backend cpp_backend = cpp::make_backend();
  static const Backend c_backend = c::make_backend();
  return language == Language::c ? c_backend : cpp_backend;
}

std::string header_name(const EmissionContext& context, const std::string& stem) {
  return stem + std::string(backend_of(context.language).header);
}

std::string source_name(Language language, const std::string& stem) {
  return stem + std::string(backend_of(language).source);
}

}  // namespace treeline
