/* Firmware, and the arm that it controls: moves the joints, and loses an encoder on the way back.
 */
#include <math.h>
#include <stdio.h>

#include "arm.h"
#include "arm_controller.h"

static arm_config config;
static arm_state state; /* zeros: idle, and the arm is held */
static arm_input input;
static arm_output output;
static float q[ARM_JOINTS] = {0, -0.7f, 0.4f, 0, 0.3f, 0}, qd[ARM_JOINTS];

static void command(int tick) { /* as a main program, a bus or a button would */
  const float there[ARM_JOINTS] = {1.2f, -1.3f, 1.0f, 0.5f, 0.8f, 0};
  const int kinds[] = {ARM_START, ARM_MOVE_JOINTS, ARM_MOVE_JOINTS};
  const int ticks[] = {100, 200, 2500};
  for (int k = 0; k < 3; ++k) {
    if (tick != ticks[k]) continue;
    input.command.kind = kinds[k];
    input.command.duration = 2;
    for (int i = 0; i < ARM_JOINTS; ++i) input.command.goal[i] = k == 1 ? there[i] : 0;
    ++input.command.sequence;
  }
}

static void timer_interrupt(int tick) { /* every millisecond */
  for (int i = 0; i < ARM_JOINTS; ++i) {
    input.q[i] = 1e-4f * roundf(1e4f * q[i]); /* counts of the encoder */
    input.qd[i] = qd[i];
  }
  if (tick >= 3400) input.q[1] = NAN;
  arm_step(&config, &state, &input, &output);
}

static void plant(void) { /* where motors and encoders would be */
  float qdd[ARM_JOINTS];
  arm_forward_dynamics(q, qd, output.tau, qdd);
  for (int i = 0; i < ARM_JOINTS; ++i) {
    qd[i] += 1e-3f * qdd[i];
    q[i] += 1e-3f * qd[i];
  }
}

int main(void) {
  arm_default_config(&config);
  config.stale_ticks = 0; /* commands may be hours apart */
  if (arm_check_config(&config, 0) != ARM_CONFIG_SOUND) return 1;
  printf("time_s,q0,q1,q2,q3,q4,q5\n");
  for (int tick = 0; tick <= 5000; ++tick) {
    command(tick);
    timer_interrupt(tick);
    if (tick == 2300) fprintf(stderr, "goal reached within %.4f rad\n", fabs(q[1] + 1.3));
    if (tick == 3400) fprintf(stderr, "fault %d, mode %d\n", (int)output.faults, (int)output.mode);
    if (tick % 50 == 0) {
      printf("%.3f", 1e-3 * tick);
      for (int i = 0; i < ARM_JOINTS; ++i) printf(",%.6f", q[i]);
      printf("\n");
    }
    plant();
  }
  fprintf(stderr, "it stands: %.3f rad/s, brakes %d\n", fabs(qd[1]), (int)output.brakes);
  return output.brakes ? 0 : 1;
}
