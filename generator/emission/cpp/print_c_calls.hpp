#pragma once

#include <vector>

#include "emission/contents.hpp"
#include "emission/generated_file.hpp"

namespace treeline::cpp {

/// Whether functions in C++ can be called from C: not those of `profile: misra`, since arrays of C
/// are pointers, which only a `reinterpret_cast` makes references to arrays; nor where the header
/// NAME.h would hide one of C's own.
bool has_c_calls(const EmissionContext& context);

/// NAME.h, NAME_joints.h and, where there are such functions, NAME_damped.h, NAME_batch.h,
/// NAME_limited.h and NAME_prefetch.h, as `language: c` has them, and c_calls.cpp, which implements
/// them by the functions of C++.
std::vector<GeneratedFile> print_c_calls(const Contents& contents);

}  // namespace treeline::cpp
