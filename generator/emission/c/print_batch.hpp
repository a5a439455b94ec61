#pragma once

#include <span>
#include <string>
#include <vector>

#include "emission/contents.hpp"
#include "emission/generated_file.hpp"
#include "program/program.hpp"

namespace treeline::c {

/// The head of a function of several states, `void NAME_batch_gravity(...)`, without what follows.
std::string print_batch_signature(const EmissionContext& context, const Program& program);

/// NAME_batch.h: functions that take rows of states, with their contracts.
GeneratedFile print_batch_header(const EmissionContext& context, std::span<const Program> programs);

/// NAME_batch.h, and a source for each function: in vectors where the scene asks for lanes, of
/// which they include a header, else in a loop over the states.
std::vector<GeneratedFile> print_batch(const Contents& contents);

}  // namespace treeline::c
