// One group of functions for one scalar. CMake compiles this file once for each.
#include "interpreter/instances.hpp"

namespace treeline::interpreter {

TREELINE_INTERPRETER_GROUP(, TREELINE_INTERPRETER_SCALAR);

}  // namespace treeline::interpreter
