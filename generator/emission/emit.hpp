#pragma once

#include <span>
#include <string>
#include <vector>

#include "description/diagnostic.hpp"
#include "emission/emission_context.hpp"
#include "program/program.hpp"

namespace treeline {

/// A file of the generated folder; `name` is relative to it and has no directory.
struct GeneratedFile {
  std::string name;
  std::string text;
};

/// The files of `generated/NAME/`, in order of name: header, a source for each program, sine and
/// cosine, Eigen wrapper, what the scene adds, CMakeLists.txt, manifest.json. Nodes are emitted in
/// the order they have in the programs (see `schedule`). Same input, same bytes. Errors, each with
/// an empty result: a name that cannot be one in C++, two functions of one name, an argument
/// without elements, a division by a structural zero, a constant that is not finite in Real.
/// `batch` are the functions to emit for `context.batch` states as well: without packs.
std::vector<GeneratedFile> emit(const EmissionContext& context, std::span<const Program> programs,
                                Diagnostics& diagnostics, std::span<const Program> batch = {});

}  // namespace treeline
