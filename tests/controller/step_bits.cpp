// Prints a digest of all that the step tells over 2000 steps, for builds that are to have the same
// bits, on a board or a host.
#include "board.hpp"
#include "step_motion.h"

namespace {

/// FNV-1a (Fowler, Noll, Vo) of the bits of one more number.
unsigned long long digest(unsigned long long so_far, double number) {
  const unsigned char* const bytes = reinterpret_cast<const unsigned char*>(&number);
  for (unsigned i = 0; i < sizeof number; ++i) so_far = (so_far ^ bytes[i]) * 0x100000001b3U;
  return so_far;
}

void print_hexadecimal(unsigned long long number, char end) {
  char text[18];
  for (int i = 0; i < 16; ++i) text[i] = "0123456789abcdef"[(number >> (60 - 4 * i)) & 15U];
  text[16] = end;
  text[17] = '\0';
  print(text);
}

}  // namespace

void run() {
  unsigned long long all = 0xcbf29ce484222325U;
  unsigned modes = 0;
  unsigned laws = 0;
  begin();
  for (int step = 0; step < 2000; ++step) {
    measure(step);
    command(step);
    puma_arm_step(&config, &state, &input, &output);
    for (const double tau : output.tau) all = digest(all, tau);
    for (const double current : output.current) all = digest(all, current);
    for (const double error : output.joint_error) all = digest(all, error);
    for (const double error : output.task_error) all = digest(all, error);
    all = digest(digest(all, output.force_error), output.factor);
    all = digest(all, output.mode + 4 * output.brakes + 8 * output.saturated);
    all = digest(all, output.faults);
    modes |= 1U << static_cast<unsigned>(output.mode);
    if (output.mode == PUMA_ARM_RUNNING) laws |= 1U << static_cast<unsigned>(state.law);
  }
  print_hexadecimal(all, ' ');
  // 15 and 7: every mode, every law
  print_hexadecimal((static_cast<unsigned long long>(modes) << 32U) | laws, '\n');
}

#if __STDC_HOSTED__ == 0
// What compilers call of themselves.
extern "C" void* memcpy(void* to, const void* from, decltype(sizeof 0) size) {
  for (decltype(size) i = 0; i < size; ++i) {
    static_cast<volatile char*>(to)[i] = static_cast<const char*>(from)[i];
  }
  return to;
}
#endif
