#pragma once

#include <string_view>

namespace treeline::package_templates {

// Files of templates/packages/, embedded when the generator is built.
extern const std::string_view kArduinoExample;
extern const std::string_view kArduinoKeywords;
extern const std::string_view kArduinoLibrary;
extern const std::string_view kCMakeLists;
extern const std::string_view kCmsisPack;
extern const std::string_view kPlatformioLibrary;
extern const std::string_view kZephyrCMakeLists;
extern const std::string_view kZephyrKconfig;
extern const std::string_view kZephyrModule;

}  // namespace treeline::package_templates
