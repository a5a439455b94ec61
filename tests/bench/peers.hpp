#pragma once

#include <optional>

#include "case.hpp"
#include "subject.hpp"

namespace treeline::bench {

/// Treeline's own interpreter in double.
Subject interpreter_subject(const Case& robot);

/// KDL, DART and Pinocchio, whose modules this build made: a subject for each route of each. What
/// one of them cannot do with the robot is said on stderr.
std::vector<Subject> peer_subjects(const Case& robot);

/// Everything that is measured on a robot: generated code of all compilers first, then the
/// interpreter, then the peers that were found when the build was configured.
std::vector<Subject> all_subjects(const Case& robot);

}  // namespace treeline::bench
