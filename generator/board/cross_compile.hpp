#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "board/board_options.hpp"
#include "board/find_tools.hpp"
#include "compilation/choose_flags.hpp"
#include "generation/generate_code.hpp"

namespace treeline {

/// Object files of a program for a board, all in one folder.
struct BoardObjects {
  std::filesystem::path folder;
  std::vector<std::string> stems;     ///< of the functions, in their order, then a controller's
  std::vector<std::string> harness;   ///< of all others
  Language language = Language::cpp;  ///< of the functions
  std::string command;                ///< compiler and flags
  std::string long_command;           ///< for long functions; empty: there is none
  std::string small_command;          ///< for functions that are small code; empty: there is none
  std::vector<FunctionFlags> flags;   ///< of the functions, in their order
  double seconds = 0;
};

/// Compiles the functions of a generated folder and the program in `work` that calls them: its
/// sources are there. Errors: a source does not compile, with the compiler's first lines.
std::optional<BoardObjects> cross_compile(const std::filesystem::path& sources,
                                          const std::vector<GeneratedFunction>& functions,
                                          const Target& target, const Tools& tools,
                                          const CompileOptions& options, const BoardOptions& board,
                                          const std::filesystem::path& work,
                                          Diagnostics& diagnostics);

/// Links the objects. Errors: it does not link; `board` says in no known way where memory is.
std::optional<std::filesystem::path> link_program(const BoardObjects& objects, const Target& target,
                                                  const Tools& tools, const BoardOptions& board,
                                                  Diagnostics& diagnostics);

/// Stems of the program's own sources.
inline constexpr const char* kMainStem = "board_main";
inline constexpr const char* kEmptyStem = "board_empty";
inline constexpr const char* kStartStem = "board_start";
inline constexpr const char* kLinkerScript = "board.ld";

}  // namespace treeline
