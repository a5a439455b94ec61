#pragma once
// limited_torque.h for several states: arrays hold element i of all states in a row.

#include "limited_torque.h"

TL_INLINE void tl_take_state(
    const real* rows, int32_t size, int32_t state, real* one) {
  for (int32_t i = 0; i < size; ++i) {
    one[i] = rows[(i * TL_STATES) + state];
  }
}

TL_INLINE void tl_put_state(
    const real* one, int32_t size, int32_t state, real* rows) {
  for (int32_t i = 0; i < size; ++i) {
    rows[(i * TL_STATES) + state] = one[i];
  }
}
