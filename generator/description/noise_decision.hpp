#pragma once

#include <string>
#include <vector>

namespace treeline {

/// A number of a file, or a relation between several, that is taken as exact.
struct NoiseDecision {
  std::string file;
  int line = 0;         ///< 1-based; 0 when unknown
  std::string element;  ///< e.g. `robot/joint[elbow]/origin`
  std::string text;     ///< e.g. `roll 1.1e-27 rad is 0`
  double change = 0;    ///< by how much, rad or m; of inertias, share of the moments
};
using NoiseDecisions = std::vector<NoiseDecision>;

}  // namespace treeline
