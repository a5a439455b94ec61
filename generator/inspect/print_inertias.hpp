#pragma once

#include <string>

#include "inspect/report.hpp"

namespace treeline {

/// For people: inertias that no body has, whether the motion feels them, and bodies that are flat;
/// empty when there is none.
std::string print_inertias(const Report& report);

}  // namespace treeline
