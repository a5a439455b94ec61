#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "certify/ask_gappa.hpp"

namespace treeline {

/// Version of Coq. Without the program or the libraries of Gappa, an error that names the packages.
std::optional<std::string> find_coq(const std::filesystem::path& folder, Diagnostics& diagnostics);

/// One file for Coq with a module for each step. Gappa leaves the equations of rewritings to be
/// proven; here each of them has a proof. Nothing if Gappa has no proof of a step.
std::optional<std::string> print_coq(const Gappa& gappa, const std::vector<ProofStep>& steps);

/// Whether Coq accepts the file.
bool accepts(const std::filesystem::path& file, const std::filesystem::path& work);

}  // namespace treeline
