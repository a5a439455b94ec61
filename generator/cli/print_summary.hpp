#pragma once

#include <string>
#include <vector>

#include "emission/compare_files.hpp"
#include "generation/generate_code.hpp"
#include "timing/tune.hpp"

namespace treeline {

/// What `treeline generate` tells when it is done.
struct Summary {
  const std::vector<GeneratedFunction>& functions;
  const std::vector<FileDifference>& differences;  ///< before anything was written
  const std::string& output;
  std::size_t files = 0;  ///< that the folder has when all is up to date
  bool compared_only = false;
  bool verbose = false;            ///< with the algorithms that were not chosen
  const Tuning* tuning = nullptr;  ///< what was measured, if anything was
};

/// A table of functions with their costs, the choices made, and the files that differ.
std::string print_text(const Summary& summary);
std::string print_json(const Summary& summary);

}  // namespace treeline
