#pragma once

#include <span>
#include <string>

#include "emission/emission_context.hpp"
#include "program/program.hpp"

namespace treeline::c {

/// CMakeLists.txt of the folder.
std::string print_project(const EmissionContext& context, std::span<const Program> programs,
                          std::span<const Program> batch);

}  // namespace treeline::c
