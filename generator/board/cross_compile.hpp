#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "compilation/compile_folder.hpp"
#include "compilation/run_commands.hpp"
#include "generation/generate_code.hpp"
#include "target/target.hpp"
#include "text/diagnostic.hpp"

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

/// Programs for a target, which start.
struct Tools {
  std::string compiler;          ///< the program, for C++
  std::string c_compiler;        ///< compiler of C
  std::string prefix;            ///< of the names of nm, size and objdump
  std::string compiler_version;  ///< first line that it prints
  Command runner;                ///< takes the program's file as its last argument
};

/// Finds the compiler of a target that has a board, and QEMU unless another runner is given.
/// Errors: a program is missing, with the package of Debian that holds it.
std::optional<Tools> find_tools(const Target& target, const std::string& runner,
                                const std::filesystem::path& work, Diagnostics& diagnostics);

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
