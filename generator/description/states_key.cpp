#include "description/states_key.hpp"

#include "description/parse_yaml.hpp"

namespace treeline {

bool states_key(const std::string& scene_text, const std::string& key) {
  Diagnostics ignored;
  const auto document = parse_yaml(scene_text, "", ignored);
  return document && document->IsMap() && (*document)[key];
}

}  // namespace treeline
