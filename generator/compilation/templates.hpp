#pragma once

#include <string_view>

namespace treeline::compilation_templates {

// Files of templates/, embedded when the generator is built.
extern const std::string_view kBatch;
extern const std::string_view kBytesOfReal;
extern const std::string_view kCBatch;
extern const std::string_view kCBatchFunction;
extern const std::string_view kCEntry;
extern const std::string_view kCFunction;
extern const std::string_view kCLimited;
extern const std::string_view kEntry;
extern const std::string_view kFunction;
extern const std::string_view kLimited;
extern const std::string_view kStep;
extern const std::string_view kStepDynamics;
extern const std::string_view kStepNumbers;

}  // namespace treeline::compilation_templates
