#pragma once

#include <optional>

#include "case.hpp"
#include "subject.hpp"

namespace treeline::bench {

/// Treeline's own interpreter in double.
Subject interpreter_subject(const Case& robot);

/// Orocos KDL: recursive Newton-Euler over the tree, and for a serial robot over the chain, with
/// the chain's mass matrix and forward dynamics. Nothing for a floating base.
std::vector<Subject> kdl_subjects(const Case& robot);

/// DART: inverse and forward dynamics and the mass matrix.
std::vector<Subject> dart_subjects(const Case& robot);

/// Pinocchio: the same, M^-1, derivatives and of J M^-1 J^T every route.
std::vector<Subject> pinocchio_subjects(const Case& robot);

/// Everything that is measured on a robot: generated code of all compilers first, then the
/// interpreter, then the peers that were found when the build was configured.
std::vector<Subject> all_subjects(const Case& robot);

}  // namespace treeline::bench
