#pragma once

#include <string>
#include <vector>

#include "emission/generated_file.hpp"

namespace treeline::misra {

/// Headers of templates/c as headers of C++, where they were filled with `@` for the robot's name
/// and `@@` for the name in capitals: names without these prefixes; types and constants declared
/// and named as in other C++; integers of a stated size. Statements stay, and so do the bits of
/// results. A name that one header declares may be used in all. Throws std::logic_error where
/// something of C is left.
void translate_to_cpp(std::vector<GeneratedFile>& headers);

}  // namespace treeline::misra
