#pragma once

#include <optional>

#include "case.hpp"
#include "subject.hpp"

namespace treeline::bench {

/// Treeline's interpreter in double.
Subject interpreter_subject(const Case& robot);

/// KDL, DART and Pinocchio, whose modules are built here: one subject for each of their routes.
/// Prints on stderr what a library cannot do with the robot.
std::vector<Subject> peer_subjects(const Case& robot);

/// All subjects for a robot: generated code of all compilers first, then the interpreter, then the
/// peers that were found when the build was configured.
std::vector<Subject> all_subjects(const Case& robot);

}  // namespace treeline::bench
