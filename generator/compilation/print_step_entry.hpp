#pragma once

#include <string>
#include <vector>

#include "emission/controller_unit.hpp"
#include "emission/generated_file.hpp"

namespace treeline {

/// Stem of the source that passes the structs of a controller's step as arrays of numbers.
inline constexpr const char* kStepStem = "treeline_check_step";

/// The text of the controller's header among the files of a robot; empty if there is none.
std::string find_controller_header(const std::string& name,
                                   const std::vector<GeneratedFile>& files);

/// Source of that stem, for the structs that the controller's header declares. `flat` is the type
/// of the arrays' numbers.
std::string print_step_entry(const std::string& name, const std::string& header, const char* flat);

/// Sources of a controller by the same laws in numbers of type `real`, whose dynamics the host
/// computes: the emitted headers of the laws, and stand-ins for the functions that they call.
std::vector<GeneratedFile> print_step_reference(const std::string& name,
                                                const std::vector<GeneratedFile>& files,
                                                const ControllerUnit& unit, const char* real);

/// Stems of what the reference compiles.
std::vector<std::string> list_reference_stems();

}  // namespace treeline
