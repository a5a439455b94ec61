#include "passes/eliminate_dead.hpp"

#include <vector>

#include "passes/rebuild.hpp"

namespace treeline {

Program eliminate_dead(const Program& program) {
  const Marks live = find_live(program);
  std::vector<std::uint32_t> order;
  for (std::uint32_t i = 0; i < live.size(); ++i) {
    if (live[i]) {
      order.push_back(i);
    }
  }
  return rebuild(program, order);
}

}  // namespace treeline
