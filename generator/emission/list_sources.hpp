#pragma once

#include <string>
#include <vector>

#include "emission/contents.hpp"

namespace treeline {

/// How a source is compiled whatever the flags of the project are.
struct OwnFlags {
  bool is_small = false;  ///< to small code
  bool is_long = false;   ///< without `kExtraPasses`
  bool is_huge = false;   ///< at no higher level than -O1
};

/// A file of the folder to compile, with its own flags.
struct Source {
  /// What it defines: the sources of functions that loop as one, the step of a controller, a
  /// function, one that only the step calls, one for several states, or what an add-on has.
  enum class Of { joined, step, function, dynamics, batch, add_on };
  std::string file;
  Of of = Of::function;
  OwnFlags flags = {};
  bool is_joined = false;  ///< compiled as part of the source that is `joined`
};

/// Lists what there is to compile. This alone decides it: CMakeLists.txt and manifest, packages and
/// `treeline_generate` write and read this list. The source that is `joined` is written by whoever
/// compiles; it is there where the language shares loops so, and two functions or more loop.
std::vector<Source> list_sources(const Contents& contents);

/// Returns the flags of a function, as `optimize` of the scene asks: small code by `size`, but for
/// what is huge.
OwnFlags choose_own_flags(Optimize optimize, const Program& program);

/// Passes of GCC that save spills and copies in straight-line code, 2 to 6 % of its bytes. Without
/// optimisation, and for long functions (`is_long`), they take minutes.
inline constexpr const char* kExtraPasses = "-flive-range-shrinkage -frename-registers";
inline constexpr const char* kNoExtraPasses = "-fno-live-range-shrinkage -fno-rename-registers";
/// GCC's and Clang's option for functions that are too long for higher levels (`is_huge`).
inline constexpr const char* kHugeFlag = "-O1";
/// GCC's and Clang's option for small code.
inline constexpr const char* kSmallCodeFlag = "-Os";

}  // namespace treeline
