#pragma once

#include <optional>
#include <string>

#include "emission/emit.hpp"
#include "generation/generate_code.hpp"

namespace treeline {

/// The source that joins the generated functions with the loop: a struct for `drive::DriveLoop`.
std::string print_robot(const Robot& robot, const Scene& control, const Generation& generation,
                        const Scene& links, const std::optional<Scene>& ground);

}  // namespace treeline
