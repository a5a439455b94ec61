#include "description/lists_functions.hpp"

#include "description/parse_yaml.hpp"

namespace treeline {

bool lists_functions(const std::string& scene_text) {
  Diagnostics ignored;
  const auto document = parse_yaml(scene_text, "", ignored);
  return document && document->IsMap() && (*document)["functions"];
}

}  // namespace treeline
