#pragma once

#include <span>
#include <string>
#include <vector>

#include "emission/emission_context.hpp"
#include "emission/generated_file.hpp"
#include "program/program.hpp"
#include "text/diagnostic.hpp"

namespace treeline {

/// The files of `generated/NAME/` in the context's language, in order of name: header, a source for
/// each program, sine and cosine, Eigen wrapper (C++), what the scene adds, CMakeLists.txt,
/// manifest.json. Nodes are emitted in the order they have in the programs (see `schedule`). Same
/// input, same bytes. Errors, each with an empty result: a name that cannot be one in the language,
/// two functions of one name, an argument without elements, a division by a structural zero, a
/// constant that is not finite in Real, what the language does not have.
/// `batch` are the functions to emit for `context.batch` states as well: without packs.
std::vector<GeneratedFile> emit(const EmissionContext& context, std::span<const Program> programs,
                                Diagnostics& diagnostics, std::span<const Program> batch = {});

}  // namespace treeline
