#include "loop_in_c.h"

#include "show/show.h"

void step_loop_in_c(void* show, const double* q, struct LoopInC* loop) {
  TreelineShow* const page = (TreelineShow*)show;
  const double qd[2] = {0.5, -0.5};
  const double tau[2] = {7.0, 8.0};
  loop->enabled = treeline_show_receive(page);
  loop->mode = page->mode;
  loop->control = page->control;
  loop->point_count = page->point_count;
  memcpy(loop->q, page->q, sizeof(loop->q));
  memcpy(loop->qd, page->qd, sizeof(loop->qd));
  memcpy(loop->point, page->points, sizeof(loop->point));
  treeline_show_value(page, "error", 0.25);
  treeline_show_value(page, "sixteen letters!", -1.0);
  treeline_show_send(page, q, qd, tau);
}
