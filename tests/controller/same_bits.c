/* Would catch: a controller in C, or of `profile: misra`, that computes something else than the plain
   one in C++. Both are led through every command with the same measurements; every bit of output and
   state of both is compared, of all that is a number.
   With TOLERANCE the second one has other algorithms: torques are compared up to this share of the
   largest, and modes. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "puma_safe_controller.h"
#include "step_motion.h"

static puma_safe_config safe_config;
static puma_safe_state safe_state;
static puma_safe_input safe_input;
static puma_safe_output safe_output;

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
  begin();
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
