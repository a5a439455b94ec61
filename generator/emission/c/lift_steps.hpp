#pragma once

#include <map>
#include <string>
#include <string_view>

namespace treeline::c {

/// The steps of sine and cosine as blocks of statements in C, by the names of their functions in
/// `header`, runtime/core/sin_cos.hpp, which is the only description of them; and `constants`,
/// those of the number's format that they use. `name` is the robot's. A step keeps the names of its
/// parameters: variables of these names have to be there. Throws std::logic_error where a step is
/// missing, or written in more than the part of C++ that is translated here.
std::map<std::string, std::string> lift_steps(std::string_view header, const std::string& name,
                                              bool single_precision);

}  // namespace treeline::c
