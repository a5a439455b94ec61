#pragma once
#include <stdint.h>

/// What the firmware streams of every cycle: bits that have to be the same on every machine.
struct Record {
  int32_t tick;
  int32_t mode;
  uint32_t faults;
  float q[6];
  float qd[6];
  float tau[6];
};

inline constexpr int kTicks = 4200;  ///< of 1 ms
