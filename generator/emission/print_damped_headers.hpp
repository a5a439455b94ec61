#pragma once

#include <vector>

#include "emission/emission_context.hpp"
#include "emission/generated_file.hpp"

namespace treeline {

/// The headers of runtime/emitted that damped control includes, but square_root.h, with its sizes:
/// damped_solve.h, symmetric_eigen.h, ldlt.h and damped_sizes.h, in C++ with endings of C++.
std::vector<GeneratedFile> print_damped_headers(const EmissionContext& context);

}  // namespace treeline
