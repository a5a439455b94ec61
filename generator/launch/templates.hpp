#pragma once

#include <string_view>

namespace treeline::launch_templates {

// A file of templates/ and headers of runtime/, embedded when the generator is built.
extern const std::string_view kRobot;
extern const std::string_view kCoreCommandLaws;
extern const std::string_view kCoreCoordinates;
extern const std::string_view kCoreDampedSolve;
extern const std::string_view kCoreEmittedBraking;
extern const std::string_view kCoreEmittedDamped;
extern const std::string_view kCoreLdlt;
extern const std::string_view kCoreMessageQueue;
extern const std::string_view kCoreMode;
extern const std::string_view kCoreOrientation;
extern const std::string_view kCoreSinCos;
extern const std::string_view kCoreSquareRoot;
extern const std::string_view kCoreSymmetricEigen;
extern const std::string_view kEmittedControllerBraking;
extern const std::string_view kEmittedControllerMeasurement;
extern const std::string_view kEmittedControllerNumbers;
extern const std::string_view kEmittedControllerRobot;
extern const std::string_view kEmittedControllerSafety;
extern const std::string_view kEmittedDampedSizes;
extern const std::string_view kEmittedDampedSolve;
extern const std::string_view kEmittedLdlt;
extern const std::string_view kEmittedOrientation;
extern const std::string_view kEmittedQuarterTurns;
extern const std::string_view kEmittedRemainderInDouble;
extern const std::string_view kEmittedRemainderInFloat;
extern const std::string_view kEmittedAngleFormat;
extern const std::string_view kEmittedSinCosInDouble;
extern const std::string_view kEmittedSinCosInFloat;
extern const std::string_view kEmittedSinCos;
extern const std::string_view kEmittedSquareRoot;
extern const std::string_view kEmittedSymmetricEigen;
extern const std::string_view kEmittedTurnMotion;
extern const std::string_view kServoClock;
extern const std::string_view kServoCycle;
extern const std::string_view kServoIntegrate;
extern const std::string_view kServoGearBacklash;
extern const std::string_view kServoJointFriction;
extern const std::string_view kServoLoop;
extern const std::string_view kServoMessage;
extern const std::string_view kServoMotionCoordinates;
extern const std::string_view kServoRobotProxy;
extern const std::string_view kServoSafeState;
extern const std::string_view kServoSafety;
extern const std::string_view kServoStateMachine;
extern const std::string_view kServoStatistics;
extern const std::string_view kServoWatchMotion;
extern const std::string_view kDriveAvoidance;
extern const std::string_view kDriveClosedLoops;
extern const std::string_view kDriveBounds;
extern const std::string_view kDriveController;
extern const std::string_view kDriveControllerBody;
extern const std::string_view kDriveGoals;
extern const std::string_view kDriveEndStops;
extern const std::string_view kDriveHeldPlaces;
extern const std::string_view kDriveImperfectRobot;
extern const std::string_view kDriveImperfectRobotBody;
extern const std::string_view kDriveLinkForces;
extern const std::string_view kDriveLoop;
extern const std::string_view kDriveObstacle;
extern const std::string_view kDriveRobot;
extern const std::string_view kDriveInstruction;
extern const std::string_view kDriveLibrary;
extern const std::string_view kDriveRecordedMotion;
extern const std::string_view kDriveReference;
extern const std::string_view kDriveTaskLaw;

}  // namespace treeline::launch_templates
