#pragma once

#include <string_view>

namespace treeline::cpp::templates {

// The files of templates/cpp/ and headers of runtime/core, embedded when the generator is built
// (see embed_files.cmake).
extern const std::string_view kBatch;
extern const std::string_view kBatchFunction;
extern const std::string_view kBatchLimited;
extern const std::string_view kCCalls;
extern const std::string_view kCCallsBatch;
extern const std::string_view kCCallsLimited;
extern const std::string_view kCCallsLimits;
extern const std::string_view kCMakeLists;
extern const std::string_view kCalls;
extern const std::string_view kContract;
extern const std::string_view kDamped;
extern const std::string_view kDeclaration;
extern const std::string_view kEigen;
extern const std::string_view kFunction;
extern const std::string_view kJoints;
extern const std::string_view kLanes;
extern const std::string_view kLimited;
extern const std::string_view kLinkArticulation;
extern const std::string_view kLinkFactors;
extern const std::string_view kLinkFriction;
extern const std::string_view kLinkFunctions;
extern const std::string_view kLinkInertia;
extern const std::string_view kLinkInputs;
extern const std::string_view kLinkMatrix;
extern const std::string_view kLinkMotion;
extern const std::string_view kLinkPose;
extern const std::string_view kLinkRows;
extern const std::string_view kLinkTable;
extern const std::string_view kLinkVectors;
extern const std::string_view kLinks;
extern const std::string_view kLoadLanes;
extern const std::string_view kLoopFunction;
extern const std::string_view kLookup;
extern const std::string_view kNamedCall;
extern const std::string_view kSinCos;
extern const std::string_view kStates;
extern const std::string_view kTorqueLimits;
extern const std::string_view kWrapper;

}  // namespace treeline::cpp::templates
