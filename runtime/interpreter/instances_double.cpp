#define TREELINE_INTERPRETER_DEFINES_INSTANCES
#include "interpreter/instances.hpp"

namespace treeline::interpreter {

TREELINE_INTERPRETER_INSTANCES(, double);

}  // namespace treeline::interpreter
