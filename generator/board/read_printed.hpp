#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace treeline {

/// Bytes that a program on a board has printed, as main.cpp.in tells, or why they are not all
/// there.
struct PrintedBytes {
  std::string bytes;
  std::string fault;  ///< empty: none
};

/// Reads them out of all that was printed; lines of others are passed over. `id` is the program's.
PrintedBytes read_printed(std::string_view text, std::string_view id);

/// Checksum of bytes, as the program computes it: FNV-1a.
std::uint32_t sum_bytes(std::string_view bytes);

}  // namespace treeline
