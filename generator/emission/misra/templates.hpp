#pragma once

#include <string_view>

namespace treeline::misra::templates {

// The files of templates/misra/, embedded when the generator is built (see embed_files.cmake).
extern const std::string_view kFunction;
extern const std::string_view kSinCos;

}  // namespace treeline::misra::templates
