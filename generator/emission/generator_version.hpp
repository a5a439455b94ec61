#pragma once

namespace treeline {

/// `0.1.0`: the version of the project that this program was built from, the same for every build
/// of it.
const char* generator_version();

}  // namespace treeline
