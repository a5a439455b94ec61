#pragma once

#include <vector>

#include "emission/contents.hpp"
#include "emission/generated_file.hpp"

namespace treeline::c {

/// NAME_batch.h, and a source for each function: in vectors where the scene asks for lanes, of
/// which they include a header, else in a loop over the states.
std::vector<GeneratedFile> print_batch(const Contents& contents);

}  // namespace treeline::c
