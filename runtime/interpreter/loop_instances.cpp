#include "interpreter/loop_instances.hpp"

namespace treeline::interpreter {

TREELINE_LOOP_INSTANCES(, double);
TREELINE_LOOP_INSTANCES(, Digits50);
TREELINE_LOOP_BIAS_INSTANCE(, Digits50);
TREELINE_CLOSING_INSTANCES(, double);

}  // namespace treeline::interpreter
