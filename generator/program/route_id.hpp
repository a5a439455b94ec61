#pragma once

#include <string>

namespace treeline {

/// By which algorithm, in which coordinates, a function is computed. The keys are what manifests
/// record and `--choices` reads: they are never given another meaning. The words are for readers.
struct RouteId {
  std::string algorithm;               ///< key: "pv-osim"
  std::string algorithm_words;         ///< "unit forces propagated inward (PV-OSIM)"
  std::string coordinates = {};        ///< key: "asked/points"; empty where there is one kind only
  std::string coordinates_words = {};  ///< "in the axes asked for at the points"
  bool limbs = false;                  ///< limbs of one shape share lanes
};

/// "pv-osim@asked/points+limbs": what tells a route from all others to a function.
std::string key_of(const RouteId& route);

/// "unit forces propagated inward (PV-OSIM), in the axes asked for at the points, alike limbs in
/// lanes"
std::string describe(const RouteId& route);

}  // namespace treeline
