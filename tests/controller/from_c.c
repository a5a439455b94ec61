/* Steps the controller from C: it must hold the arm, start, and say so. */
#include <stdio.h>
#include "puma_arm_controller.h"

static puma_arm_config config;
static puma_arm_state state;
static puma_arm_input input;
static puma_arm_output output;

int main(void) {
  puma_arm_default_config(&config);
  puma_arm_step(&config, &state, &input, &output);
  if (output.mode != PUMA_ARM_IDLE || output.faults != 0U || output.tau[1] == 0.0) return 1;
  input.command.kind = PUMA_ARM_START;
  input.command.sequence = 1U;
  puma_arm_step(&config, &state, &input, &output);
  if (output.mode != PUMA_ARM_RUNNING) return 2;
  if (puma_arm_check_config(&config, 0) != PUMA_ARM_CONFIG_SOUND) return 5;
  config.jump = 1000.0;
  config.following = 1000.0;
  input.q[0] = 100.0;
  puma_arm_step(&config, &state, &input, &output);
  if (output.faults != (uint32_t)PUMA_ARM_FAULT_POSITION) return 3;
  return puts("as it should be") < 0 ? 4 : 0;
}
