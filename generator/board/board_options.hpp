#pragma once

#include <filesystem>
#include <string>

namespace treeline {

/// A board of one's own in place of the one that QEMU imitates; all empty: that one.
struct BoardOptions {
  /// Program and its arguments, to which that of the ELF file is added: it lets the board run that
  /// and prints what the board sends. Words as of a shell without quotes.
  std::string runner;
  /// Source with functions of the board: those that board.hpp declares as `treeline_board_...`.
  std::filesystem::path port;
  /// Where code and data are, and bytes of data: three numbers with commas between.
  std::string memory;
};

}  // namespace treeline
