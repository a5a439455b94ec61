#include "description/list_rows.hpp"

namespace treeline {

std::string list_rows(const ScenePoint& point, std::string_view between) {
  std::string list;
  for (std::size_t i = 0; i < kRowNames.size(); ++i) {
    if (!point.rows[i]) continue;
    if (!list.empty()) list += between;
    list += kRowNames[i];
  }
  return list;
}

}  // namespace treeline
