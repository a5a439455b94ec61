/* A PUMA's controller that is led through every command, mode and law, by measurements that are
   exact in every build: no library computes them. */
#include "puma_arm_controller.h"

enum { n = PUMA_ARM_JOINTS };

static puma_arm_config config;
static puma_arm_state state;
static puma_arm_input input;
static puma_arm_output output;

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
      for (i = 0; i < 9; ++i) input.command.rotation[i] = turned[i];
      send(PUMA_ARM_MOVE_POINT, 0.7);
      break;
    case 900:
      input.command.direction[2] = -1;
      input.command.force = 20;
      send(PUMA_ARM_PRESS, 0.2);
      break;
    case 1000:
      input.command.point = 1; /* leave the task, where there are behaviours */
      send(PUMA_ARM_BEHAVE, 0.03);
      break;
    case 1050:
      input.command.point = 0; /* and do it again */
      send(PUMA_ARM_BEHAVE, 0.03);
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

/* An arm that swings along parabolas, slow enough for the limits of speed; for some steps it is not
   measured. */
static void measure(int step) {
  int i;
  for (i = 0; i < n; ++i) {
    const double s = 0.001 * ((step + 700 * i) % 2000) - 1;
    const double away = s < 0 ? -s : s;
    input.q[i] = 0.2 * i - 0.4 + 0.4 * (s * (1 - away));
    input.qd[i] = 0.4 * (1 - 2 * away);
    if (i < 3) input.force[i] = 20 * (s * (1 - away));
  }
  if (step > 1800 && step < 1860) input.q[2] = __builtin_nan("");
}

/* The arm swings whatever it is told, which shall be no fault; within the torques, for at a limit
   it hangs on a rounding whether an integral stops. */
static void begin(void) {
  puma_arm_default_config(&config);
  config.following = 1e6;
  config.hold_reach = 10;
  config.point_speed = 100;
  config.point_turn = 100;
}
