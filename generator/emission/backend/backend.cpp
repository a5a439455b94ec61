#include "emission/backend/backend.hpp"

#include "emission/c/backend.hpp"
#include "emission/cpp/backend.hpp"

namespace treeline {

const Backend& backend_of(Language language) {
  static const Backend cpp_backend = cpp::make_backend();
  static const Backend c_backend = c::make_backend();
  return language == Language::c ? c_backend : cpp_backend;
}

}  // namespace treeline
