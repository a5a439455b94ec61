#include "interpreter/loop_instances.hpp"

namespace treeline::interpreter {

TREELINE_CLOSING_INSTANCES(, double);

}  // namespace treeline::interpreter
