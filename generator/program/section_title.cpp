#include "program/section_title.hpp"

#include <fmt/format.h>

namespace treeline {

std::string print(const SectionTitle& title) {
  if (title.link == 0) return title.step;
  return fmt::format("link {} ({}), {}", title.link, title.link_name, title.step);
}

}  // namespace treeline
