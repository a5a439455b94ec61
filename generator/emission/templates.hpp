#pragma once

#include <string_view>

namespace treeline::templates {

// Files of templates/ that every language shares, embedded when the generator is built (see
// embed_files.cmake).
extern const std::string_view kIdentity;
extern const std::string_view kManifest;
extern const std::string_view kPrefetchC;
extern const std::string_view kPrefetchCpp;
extern const std::string_view kPrefetchHeaderC;
extern const std::string_view kPrefetchHeaderCpp;

}  // namespace treeline::templates
