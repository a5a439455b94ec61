/* The step of a controller on measurements and commands that standard input states, a line a step;
   prints tau, mode and faults. What a unit of FMI is compared with. */
#include <stdio.h>

#include "arm_controller.h"

static arm_config config;
static arm_state state;
static arm_input input;
static arm_output output;

static int read(double* value) {
  return scanf("%lf", value) == 1;
}

int main(void) {
  int i;
  arm_default_config(&config);
  for (;;) {
    double number;
    for (i = 0; i < ARM_JOINTS; ++i) {
      if (!read(&number)) return 0;
      input.q[i] = number;
    }
    for (i = 0; i < ARM_JOINTS; ++i) input.qd[i] = read(&number) ? number : 0;
    input.command.kind = read(&number) ? (int32_t)number : 0;
    input.command.sequence = read(&number) ? (uint32_t)number : 0;
    input.command.duration = read(&number) ? number : 0;
    for (i = 0; i < ARM_JOINTS; ++i) input.command.goal[i] = read(&number) ? number : 0;
    arm_step(&config, &state, &input, &output);
    for (i = 0; i < ARM_JOINTS; ++i) printf("%.17g ", output.tau[i]);
    printf("%d %u\n", (int)output.mode, (unsigned)output.faults);
  }
}
