#pragma once

#include <string_view>

namespace treeline::templates {

// Files of templates/ and runtime/emitted that every language shares, embedded when the generator
// is built (see embed_files.cmake).
extern const std::string_view kControllerBraking;
extern const std::string_view kControllerCommands;
extern const std::string_view kControllerCompliance;
extern const std::string_view kControllerConfig;
extern const std::string_view kControllerDrift;
extern const std::string_view kControllerFaults;
extern const std::string_view kControllerFollowing;
extern const std::string_view kControllerHeader;
extern const std::string_view kControllerLaws;
extern const std::string_view kControllerMailbox;
extern const std::string_view kControllerMeasurement;
extern const std::string_view kControllerNumbers;
extern const std::string_view kControllerPace;
extern const std::string_view kControllerPoints;
extern const std::string_view kControllerReferences;
extern const std::string_view kControllerRobot;
extern const std::string_view kControllerSafety;
extern const std::string_view kControllerSource;
extern const std::string_view kControllerStep;
extern const std::string_view kDampedSolve;
extern const std::string_view kEights;
extern const std::string_view kEightsWrittenOut;
extern const std::string_view kEnterRows;
extern const std::string_view kForceBasis;
extern const std::string_view kIdentity;
extern const std::string_view kLdlt;
extern const std::string_view kLimitProgram;
extern const std::string_view kLimitedStates;
extern const std::string_view kLimitedTorque;
extern const std::string_view kManifest;
extern const std::string_view kNumberBits;
extern const std::string_view kOrientation;
extern const std::string_view kPrefetchC;
extern const std::string_view kPrefetchCpp;
extern const std::string_view kPrefetchHeaderC;
extern const std::string_view kPrefetchHeaderCpp;
extern const std::string_view kQuadraticProgram;
extern const std::string_view kQuarterTurns;
extern const std::string_view kQuintic;
extern const std::string_view kRemainderInDouble;
extern const std::string_view kRemainderInFloat;
extern const std::string_view kSelftestFunction;
extern const std::string_view kSelftestHeader;
extern const std::string_view kSelftestSource;
extern const std::string_view kSelftestStep;
extern const std::string_view kSinCosByTables;
extern const std::string_view kSinCosInDouble;
extern const std::string_view kSinCosInFloat;
extern const std::string_view kSinCosOfArrays;
extern const std::string_view kSolveColumns;
extern const std::string_view kSquareRoot;
extern const std::string_view kSquareRootBySteps;
extern const std::string_view kSymmetricEigen;
extern const std::string_view kTorqueLimits;
extern const std::string_view kTurnMotion;

}  // namespace treeline::templates
