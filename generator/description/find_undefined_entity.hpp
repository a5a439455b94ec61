#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace treeline {

/// References of the form `&name;` in attributes, to entities that XML itself does not define.
/// tinyxml2 leaves them as they are written; strict readers refuse the file.
struct UndefinedEntities {
  int line = 0;           ///< of the first, from 1 on
  std::string attribute;  ///< that has it
  std::string first;      ///< as written
  std::size_t count = 0;  ///< of all
};

/// Finds the undefined entities of the text; nothing when there are none.
std::optional<UndefinedEntities> find_undefined_entities(std::string_view text);

}  // namespace treeline
