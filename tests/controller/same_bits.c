/* Would catch: a controller in C, or of `profile: misra`, that computes something else than the plain
   one in C++. Both are led through every command with the same measurements; every bit of output and
   state of both is compared, of all that is a number.
   With TOLERANCE the second one has other algorithms: torques are compared up to this share of the
   largest, and modes. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "puma_arm_controller.h"
#include "puma_safe_controller.h"

enum { n = PUMA_ARM_JOINTS };

static puma_arm_config config;
static puma_arm_state state;
static puma_arm_input input;
static puma_arm_output output;
static puma_safe_config safe_config;
static puma_safe_state safe_state;
static puma_safe_input safe_input;
static puma_safe_output safe_output;

static void send(int32_t kind, double duration) {
  input.command.kind = kind;
  ++input.command.sequence;
  input.command.duration = duration;
}

/* The command that begins at this step, if any. */
static void command(int step) {
  static const double turned[9] = {0, -1, 0, 1, 0, 0, 0, 0, 1};
  int i;
  switch (step) {
    case 10:
      send(PUMA_ARM_START, 0);
      break;
    case 200:
      for (i = 0; i < n; ++i) input.command.goal[i] = 0.3 * i - 0.5;
      send(PUMA_ARM_MOVE_JOINTS, 0.4);
      break;
    case 500:
      input.command.position[0] = 0.5;
      input.command.position[1] = 0.2;
      input.command.position[2] = 0.4;
      memcpy(input.command.rotation, turned, sizeof turned);
      send(PUMA_ARM_MOVE_POINT, 0.7);
      break;
    case 900:
      input.command.direction[2] = -1;
      input.command.force = 20;
      send(PUMA_ARM_PRESS, 0.2);
      break;
    case 1100:
      for (i = 0; i < n; ++i) config.joint_stiffness[i] = 30;
      for (i = 0; i < n; ++i) config.joint_damping_ratio[i] = 0.7;
      send(PUMA_ARM_COMPLY, 0);
      break;
    case 1150:
      config.observer = 300;
      send(PUMA_ARM_LEAD_JOINTS, 0.3);
      break;
    case 1200:
      config.observer = 0;
      send(PUMA_ARM_LEAD_POINT, 0.3);
      break;
    case 1300:
      send(PUMA_ARM_STOP, 0);
      break;
    case 1600:
      send(PUMA_ARM_EMERGENCY_STOP, 0);
      break;
    case 1650:
      send(PUMA_ARM_RESET, 0);
      break;
    case 1700:
      send(PUMA_ARM_START, 0);
      break;
    default:
      break;
  }
}

/* An arm that swings, slow enough for the limits of speed; for some steps it is not measured. */
static void measure(int step) {
  const double t = step * config.period;
  int i;
  for (i = 0; i < n; ++i) {
    input.q[i] = 0.2 * i - 0.4 + 0.1 * sin(3 * t + i);
    input.qd[i] = 0.3 * cos(3 * t + i);
  }
  if (step > 1800 && step < 1860) input.q[2] = NAN;
  for (i = 0; i < 3; ++i) input.force[i] = 5 * sin(t + i);
}

#ifdef TOLERANCE
static int is_same(void) {
  double largest = 0;
  int i;
  for (i = 0; i < n; ++i) largest = fmax(largest, fabs(output.tau[i]));
  for (i = 0; i < n; ++i) {
    if (!(fabs(output.tau[i] - safe_output.tau[i]) <= TOLERANCE * largest)) return 0;
  }
  return output.mode == safe_output.mode;
}
#else
static int is_same(void) {
  return memcmp(&state, &safe_state, sizeof state) == 0 &&
         memcmp(&output, &safe_output, sizeof output) == 0;
}
#endif

int main(void) {
  int finite = 0, modes = 0, step;
  if (sizeof safe_input != sizeof input || sizeof safe_state != sizeof state ||
      sizeof safe_output != sizeof output || sizeof safe_config != sizeof config) {
    printf("other structs\n");
    return 1;
  }
  puma_arm_default_config(&config);
  puma_safe_default_config(&safe_config);
  if (memcmp(&config, &safe_config, sizeof config) != 0) {
    printf("other defaults\n");
    return 1;
  }
  /* The arm swings whatever it is told, which shall be no fault. */
  config.following = 1e6;
  config.hold_reach = 10;
  /* Within the torques, for at a limit it hangs on a rounding whether an integral stops. */
  config.point_speed = 100;
  config.point_turn = 100;
  for (step = 0; step < 2000; ++step) {
    measure(step);
    command(step);
    memcpy(&safe_config, &config, sizeof config);
    memcpy(&safe_input, &input, sizeof input);
    puma_arm_step(&config, &state, &input, &output);
    puma_safe_step(&safe_config, &safe_state, &safe_input, &safe_output);
    if (!is_same()) {
      printf("other bits at step %d: tau[1] %.17g and %.17g\n", step, output.tau[1],
             safe_output.tau[1]);
      return 1;
    }
    finite += output.tau[1] != 0;
    modes |= 1 << output.mode;
  }
  /* All modes and both laws were seen. */
  if (finite < 1900 || modes != 15) {
    printf("only %d steps and modes %d\n", finite, modes);
    return 1;
  }
  return 0;
}
