#pragma once

#include <string_view>

namespace treeline::board_templates {

// Files of templates/board/, embedded when the generator is built.
extern const std::string_view kAarch64;
extern const std::string_view kBoard;
extern const std::string_view kCase;
extern const std::string_view kCortexM;
extern const std::string_view kLinkerScript;
extern const std::string_view kMain;
extern const std::string_view kRiscv;
extern const std::string_view kSelftest;
extern const std::string_view kStep;
extern const std::string_view kStepHead;

}  // namespace treeline::board_templates
