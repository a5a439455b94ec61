#pragma once
// Commands from one thread or interrupt to another without locks: the four-slot
// mechanism of Simpson (IEE Proc. 137 E, 1990). Two pairs of two places: whoever
// writes avoids the pair that is read, and in the other the place that was written
// last.

#include <stdint.h>

#include "controller_robot.h"

#if !defined(__GNUC__)
#include <TL_ATOMICS>
#endif

/// Reads and writes of the numbers that both sides share, in one order for all.
TL_INLINE uint32_t tl_read_shared(const uint32_t* number) {
#if defined(__GNUC__)
  return __atomic_load_n(number, __ATOMIC_SEQ_CST);
#else
  const volatile uint32_t* const shared = number;
  TL_FENCE;
  const uint32_t read = *shared;
  TL_FENCE;
  return read;
#endif
}

TL_INLINE void tl_write_shared(uint32_t value, uint32_t* number) {
#if defined(__GNUC__)
  __atomic_store_n(number, value, __ATOMIC_SEQ_CST);
#else
  volatile uint32_t* const shared = number;
  TL_FENCE;
  *shared = value;
  TL_FENCE;
#endif
}

/// Leaves a command in the mailbox.
TL_INLINE void tl_leave_command(const TlCommand* command, TlMailbox* mailbox) {
  const uint32_t pair = 1U - tl_read_shared(&mailbox->reading);
  const uint32_t place = 1U - tl_read_shared(&mailbox->newest[pair]);
  tl_copy_command(command, &mailbox->places[(2U * pair) + place]);
  tl_write_shared(place, &mailbox->newest[pair]);
  tl_write_shared(pair, &mailbox->latest);
}

/// Takes the command that was left last.
TL_INLINE void tl_take_newest(TlMailbox* mailbox, TlCommand* command) {
  const uint32_t pair = tl_read_shared(&mailbox->latest);
  tl_write_shared(pair, &mailbox->reading);
  const uint32_t place = tl_read_shared(&mailbox->newest[pair]);
  tl_copy_command(&mailbox->places[(2U * pair) + place], command);
}
