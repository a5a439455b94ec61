#include "emission/generated_file.hpp"

namespace treeline {

const char* generator_version() {
  return TREELINE_VERSION;  // CMake's PROJECT_VERSION
}

}  // namespace treeline
