// Contacts, objects and loops for one scalar: together, since they share dual numbers, which take
// the longest to compile. CMake compiles this file once for each scalar.
#include "interpreter/loop_instances.hpp"

namespace treeline::interpreter {

TREELINE_INTERPRETER_CONTACTS_AND_OBJECTS(, TREELINE_INTERPRETER_SCALAR);
TREELINE_LOOP_INSTANCES(, TREELINE_INTERPRETER_SCALAR);

}  // namespace treeline::interpreter
