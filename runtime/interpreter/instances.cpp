// All functions for one scalar. CMake compiles this file once for each.
#include "interpreter/loop_instances.hpp"

namespace treeline::interpreter {

TREELINE_INTERPRETER_DYNAMICS(, TREELINE_INTERPRETER_SCALAR);
TREELINE_INTERPRETER_OPERATIONAL_SPACE(, TREELINE_INTERPRETER_SCALAR);
TREELINE_INTERPRETER_CONTACTS_AND_OBJECTS(, TREELINE_INTERPRETER_SCALAR);
TREELINE_LOOP_INSTANCES(, TREELINE_INTERPRETER_SCALAR);

}  // namespace treeline::interpreter
