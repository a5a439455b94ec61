#pragma once
// Commands from one thread or interrupt to another without locks: the four-slot mechanism of
// Simpson (IEE Proc. 137 E, 1990). Two pairs of two places: whoever writes avoids the pair that is
// read, and in the other the place that was written last. C++17, freestanding, fixed size.

#include <stddef.h>
#include <stdint.h>

#if !defined(__GNUC__)
#include <atomic>
#endif

namespace treeline::core {

/// Reads and writes of the numbers that both sides share, in one order for all.
inline uint32_t read_shared(const uint32_t& number) noexcept {
#if defined(__GNUC__)
  return __atomic_load_n(&number, __ATOMIC_SEQ_CST);
#else
  std::atomic_thread_fence(std::memory_order_seq_cst);
  const uint32_t read = *static_cast<const volatile uint32_t*>(&number);
  std::atomic_thread_fence(std::memory_order_seq_cst);
  return read;
#endif
}

inline void write_shared(uint32_t& number, uint32_t value) noexcept {
#if defined(__GNUC__)
  __atomic_store_n(&number, value, __ATOMIC_SEQ_CST);
#else
  std::atomic_thread_fence(std::memory_order_seq_cst);
  *static_cast<volatile uint32_t*>(&number) = value;
  std::atomic_thread_fence(std::memory_order_seq_cst);
#endif
}

/// Copies a command without the memcpy that an assignment may call, and firmware may lack.
template <class Command>
inline void copy_command(const Command& from, Command& to) noexcept {
  const auto* const source = static_cast<const unsigned char*>(static_cast<const void*>(&from));
  auto* const target = static_cast<unsigned char*>(static_cast<void*>(&to));
  for (size_t i = 0; i < sizeof(Command); ++i) {
    target[i] = source[i];
  }
}

/// Leaves a command in the mailbox.
template <class Mailbox, class Command>
inline void post(Mailbox& mailbox, const Command& command) noexcept {
  const uint32_t pair = 1U - read_shared(mailbox.reading);
  const uint32_t place = 1U - read_shared(mailbox.newest[pair]);
  copy_command(command, mailbox.places[(2U * pair) + place]);
  write_shared(mailbox.newest[pair], place);
  write_shared(mailbox.latest, pair);
}

/// Takes the command that was left last.
template <class Mailbox, class Command>
inline void fetch(Mailbox& mailbox, Command& command) noexcept {
  const uint32_t pair = read_shared(mailbox.latest);
  write_shared(mailbox.reading, pair);
  const uint32_t place = read_shared(mailbox.newest[pair]);
  copy_command(mailbox.places[(2U * pair) + place], command);
}

}  // namespace treeline::core
