#pragma once

#include "emission/emission_context.hpp"
#include "emission/generated_file.hpp"

namespace treeline {

/// square_root.h, in C++ square_root.hpp, which includes that of sines. For `profile: misra` it is
/// Heron's steps, whose last digit integers decide, and includes nothing.
GeneratedFile print_square_root(const EmissionContext& context);

}  // namespace treeline
