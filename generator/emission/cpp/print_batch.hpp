#pragma once

#include <vector>

#include "emission/contents.hpp"
#include "emission/generated_file.hpp"

namespace treeline::cpp {

/// `NAME_batch.hpp`, which declares the functions for `context.batch` states a call, a source for
/// each, and the headers that these include.
std::vector<GeneratedFile> print_batch(const Contents& contents);

}  // namespace treeline::cpp
