// The host in the place of a board: semihosting's open and write, and no count of instructions.
#include <cstdio>

#include "board.hpp"

const int kCallsAtOnce = 1;

uint64_t begin_count() {
  return 0;
}
uint64_t end_count(uint64_t) {
  return 0;
}

intptr_t ask_host(uintptr_t operation, const void* arguments) {
  constexpr uintptr_t kOpen = 1;
  const auto* const given = static_cast<const uintptr_t*>(arguments);
  if (operation == kOpen) {
    return reinterpret_cast<intptr_t>(std::fopen(reinterpret_cast<const char*>(given[0]), "wb"));
  }
  auto* const file = reinterpret_cast<std::FILE*>(given[0]);
  std::fwrite(reinterpret_cast<const void*>(given[1]), 1, given[2], file);
  std::fflush(file);
  return 0;
}

int main() {
  run();
}
