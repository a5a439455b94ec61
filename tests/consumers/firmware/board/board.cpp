// What a Cortex-M needs to run one function under QEMU: vectors, the floating-point unit switched
// on, a clock that counts instructions (with `-icount shift=0` one per nanosecond; a tick of the
// board's clock of 25 MHz is 40 instructions), and output to the host by semihosting.
#include "board.hpp"

extern "C" {
extern unsigned stack_top;
[[noreturn]] void reset();
}

namespace {

volatile unsigned& at(unsigned address) {
  return *reinterpret_cast<volatile unsigned*>(address);
}

/// Asks the host for an operation `what` of Arm's semihosting.
void ask_host(unsigned what, const void* with) {
  register unsigned operation __asm__("r0") = what;
  register const void* argument __asm__("r1") = with;
  __asm__ volatile("bkpt 0xab" : "+r"(operation) : "r"(argument) : "memory");
}

[[noreturn]] void fault() {
  print("fault\n");
  for (;;) {
    ask_host(0x18, reinterpret_cast<const void*>(0x20024));  // ended with an error
  }
}

constexpr unsigned kClockMask = 0xffffff;

}  // namespace

unsigned ticks() {
  return kClockMask - at(0xe000e018);
}

unsigned instructions_since(unsigned start) {
  return ((ticks() - start) & kClockMask) * 40;
}

void print(const char* text) {
  ask_host(0x04, text);
}

extern "C" [[noreturn]] void reset() {
  at(0xe000ed88) |= 0xfU << 20;  // CPACR: coprocessors 10 and 11, the floating-point unit
  __asm__ volatile("dsb\n\tisb" ::: "memory");
  at(0xe000e014) = kClockMask;  // SysTick: reload,
  at(0xe000e018) = 0;           // start there,
  at(0xe000e010) = 5;           // the core's clock, no interrupt
  run();
  for (;;) {
    ask_host(0x18, reinterpret_cast<const void*>(0x20026));  // ended successfully
  }
}

extern "C" __attribute__((section(".vectors"), used)) const void* const vectors[4] = {
    &stack_top, reinterpret_cast<const void*>(&reset), reinterpret_cast<const void*>(&fault),
    reinterpret_cast<const void*>(&fault)};
