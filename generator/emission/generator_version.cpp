#include "emission/generator_version.hpp"

namespace treeline {

const char* generator_version() {
  return TREELINE_VERSION;  // CMake's PROJECT_VERSION
}

}  // namespace treeline
