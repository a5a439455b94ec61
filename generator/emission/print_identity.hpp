#pragma once

#include <string>
#include <vector>

#include "emission/emission_context.hpp"
#include "emission/generated_file.hpp"

namespace treeline {

/// Stem of the source that defines NAME_id.
inline constexpr const char* kIdentityStem = "id";

/// SHA-256 of what `LC_ALL=C sha256sum` prints of the files in order of their names: of all but the
/// manifest and the source of NAME_id, which have this digest in them.
std::string digest_of_files(const std::vector<GeneratedFile>& files);

/// Elements of NAME_id, with the zero at its end.
std::size_t size_of_identity(const EmissionContext& context);

/// The source that defines NAME_id: the generator's version, the robot's name, and the digest of
/// the other files.
GeneratedFile print_identity(const EmissionContext& context,
                             const std::vector<GeneratedFile>& files);

}  // namespace treeline
