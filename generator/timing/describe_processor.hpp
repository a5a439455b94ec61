#pragma once

#include <string>

namespace treeline {

/// Model and family of this machine's processor, as Linux names them: "Intel(R) Xeon(R), family 6".
/// Figures are only comparable on the same.
std::string describe_processor();

}  // namespace treeline
