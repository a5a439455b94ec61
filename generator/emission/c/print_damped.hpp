#pragma once

#include <vector>

#include "emission/contents.hpp"
#include "emission/generated_file.hpp"

namespace treeline::c {

/// NAME_damped.h and damped_control_torque.c, composed of others of the functions. Throws
/// std::logic_error where one of `kDampedFunctions` is not among them.
std::vector<GeneratedFile> print_damped(const Contents& contents);

}  // namespace treeline::c
