#pragma once

#include <string_view>

namespace treeline::c::templates {

// The files of templates/c/, embedded when the generator is built (see embed_files.cmake).
extern const std::string_view kBatch;
extern const std::string_view kBatchFunction;
extern const std::string_view kBatchLimited;
extern const std::string_view kBatchLimitedSource;
extern const std::string_view kCMakeLists;
extern const std::string_view kContract;
extern const std::string_view kDamped;
extern const std::string_view kDampedSource;
extern const std::string_view kDeclaration;
extern const std::string_view kFunction;
extern const std::string_view kJoints;
extern const std::string_view kLanes;
extern const std::string_view kLanesOfCount;
extern const std::string_view kLimited;
extern const std::string_view kLimitedSource;
extern const std::string_view kLinks;
extern const std::string_view kLoopFunction;
extern const std::string_view kSinCosStates;
extern const std::string_view kStates;

}  // namespace treeline::c::templates
