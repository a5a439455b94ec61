#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "certify/proof_step.hpp"
#include "text/diagnostic.hpp"

namespace treeline {

/// Writes each step as a script for Gappa: FOLDER/FUNCTION/step_0001.g, and so on. Older scripts
/// of that name are removed. Returns false and reports an error if that fails.
bool write_proofs(const std::filesystem::path& folder, const std::string& function,
                  const std::vector<ProofStep>& steps, Precision precision,
                  Diagnostics& diagnostics);

}  // namespace treeline
