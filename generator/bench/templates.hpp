#pragma once

#include <string_view>

namespace treeline::bench_templates {

// Files of templates/, embedded when the generator is built.
extern const std::string_view kLibrarySines;

}  // namespace treeline::bench_templates
