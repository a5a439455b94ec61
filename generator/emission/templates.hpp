#pragma once

#include <string_view>

namespace treeline::templates {

// Files of templates/ that every language shares, embedded when the generator is built (see
// embed_files.cmake).
extern const std::string_view kManifest;

}  // namespace treeline::templates
