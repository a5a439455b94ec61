#include <array>

#include "emission/backend.hpp"
#include "emission/c/print_files.hpp"
#include "emission/cpp/print_files.hpp"
#include "emission/opencl/print_files.hpp"

namespace treeline {

const Backend& backend_of(Language language) {
  // In the order of the enumerators.
  static const std::array<Backend, 3> backends = {cpp::make_backend(), c::make_backend(),
                                                  opencl::make_backend()};
  return backends.at(static_cast<std::size_t>(language));
}

std::string header_name(const EmissionContext& context, const std::string& stem) {
  return stem + std::string(backend_of(context.language).header);
}

std::string source_name(Language language, const std::string& stem) {
  return stem + std::string(backend_of(language).source);
}

}  // namespace treeline
