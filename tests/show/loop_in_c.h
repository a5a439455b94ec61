#pragma once
// A control loop of two joints in C99, which copies the goals of the page.

#ifdef __cplusplus
extern "C" {
#endif

/// What the loop has got.
struct LoopInC {
  int enabled, mode, control, point_count;
  double q[2], qd[2], point[7];
};

/// One cycle of the loop, which shows that it is at `q`. `show` is a TreelineShow.
void step_loop_in_c(void* show, const double* q, struct LoopInC* loop);

#ifdef __cplusplus
}
#endif
