#pragma once

#include <string_view>

namespace treeline::c {

/// Whether the header NAME.h would hide one of C's own, as `math` does.
bool hides_header(std::string_view name);

}  // namespace treeline::c
