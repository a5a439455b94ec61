#include <algorithm>
#include <vector>

#include "emission/costs.hpp"
#include "emission/print_link_inputs.hpp"
#include "emission/print_link_table.hpp"
#include "emission/print_parts.hpp"
#include "program/ending.hpp"
#include "program/link_loops.hpp"

namespace treeline {
namespace {

/// Numbers of the work space in `runtime/emitted/link_work.h`.
std::size_t count_work(const LinkLoops& loops) {
  const LinkTableData& table = loops.table;
  const std::size_t links = table.links.size();
  const auto slots = static_cast<std::size_t>(table.slots);
  const std::size_t rows = table.rows.size();
  const std::size_t points = table.points.size();
  std::size_t count = 9 * links + 9 * slots + 9 * static_cast<std::size_t>(table.rotations);
  if (loops.uses_matrix) count += 31 * links;
  if (loops.uses_factors) {
    count +=
        (table.couplings.empty() ? 7 * links + 21 * slots : 31 * links) + count_base_entries(table);
  }
  if (loops.uses_rows) count += 18 * points + (8 + rows) * rows;
  count += 10 * table.loaded_links.size();
  count += (changes_rotors(loops) ? links : 0) + (changes_drives(loops) ? 3 * links : 0) +
           (changes_frictions(loops) ? 2 * links : 0);
  if (moves_points(table)) count += 13 * points;
  return count;
}

/// Values that are alive at once, at most.
std::size_t count_live_values(const Program& program) {
  const std::vector<Node>& nodes = program.graph.nodes();
  std::vector<std::size_t> last_use(nodes.size(), 0);
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const int operands = operation(nodes[i].op).operands;
    if (operands >= 1) {
      last_use[nodes[i].a] = i;
    }
    if (operands == 2) {
      last_use[nodes[i].b] = i;
    }
  }
  std::vector<std::size_t> dying(nodes.size(), 0);
  std::size_t live = 0;
  std::size_t most = 0;
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    if (operation(nodes[i].op).operands > 0 && last_use[i] > i) {
      ++live;
      ++dying[last_use[i]];
    }
    most = std::max(most, live);
    live -= dying[i];
  }
  return most;
}

/// Numbers of the arrays that only the routine reads.
std::size_t count_arrays(const Ending& ending) {
  std::size_t count = ending.work;
  for (const Result& result : ending.lines.results) {
    if (is_only_read(ending, result)) count += result.values.size();
  }
  return count;
}

}  // namespace

std::size_t count_stack_values(const Program& program, bool misra) {
  if (program.loops) return count_work(*program.loops);
  if (program.ending) {
    return count_live_values(program.ending->lines) + count_arrays(*program.ending);
  }
  return count_live_values(program) + (misra ? count_shared_values(program) : 0);
}

}  // namespace treeline
