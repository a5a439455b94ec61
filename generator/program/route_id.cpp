#include "program/route_id.hpp"

namespace treeline {

std::string key_of(const RouteId& route) {
  return route.algorithm + (route.coordinates.empty() ? "" : "@" + route.coordinates) +
         (route.limbs ? "+limbs" : "");
}

std::string describe(const RouteId& route) {
  const std::string& words = route.coordinates_words;
  return route.algorithm_words + (words.empty() ? "" : ", " + words) +
         (route.limbs ? ", alike limbs in lanes" : "");
}

}  // namespace treeline
