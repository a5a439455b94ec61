#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "generation/generate_code.hpp"
#include "text/diagnostic.hpp"

namespace treeline {

/// Generated code of one name, whose files are in the folder of that name.
struct CompiledPart {
  std::string name;
  const Generation* generation = nullptr;
};

/// Compiles the parts and `robot.cpp`, which all lie in `work` beside `runtime/`, and links them to
/// a shared library in `work`, whose path is returned; empty after an error. A library that an
/// earlier run made of the same bytes is taken instead, see `folder_of_kept_libraries`. `progress`
/// receives the number of sources that are done and of all.
std::filesystem::path compile_robot(const std::vector<CompiledPart>& parts,
                                    const std::filesystem::path& work,
                                    const std::function<void(int, int)>& progress,
                                    Diagnostics& diagnostics);

}  // namespace treeline
