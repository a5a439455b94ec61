#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "emission/emission_context.hpp"
#include "emission/generated_file.hpp"
#include "emission/list_sources.hpp"
#include "program/program.hpp"

namespace treeline {

inline constexpr const char* kManifestName = "manifest.json";

/// `text` as a JSON string, with its quotes.
std::string quote_json(std::string_view text);

/// manifest.json: digests of the inputs and of all other `files`, what each function costs, what
/// was chosen, how the sources are compiled, and the names of all files and its own, which is how
/// the next generation knows what is its own.
std::string print_manifest(const EmissionContext& context, std::span<const Program> programs,
                           const std::vector<GeneratedFile>& files,
                           const std::vector<Source>& sources);

/// The files that a manifest lists; none when the text is not a manifest.
std::vector<std::string> read_manifest_files(std::string_view manifest);

}  // namespace treeline
