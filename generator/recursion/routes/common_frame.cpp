#include <algorithm>
#include <array>
#include <utility>

#include "core/in_eights.hpp"
#include "recursion/methods/forward_kinematics.hpp"
#include "recursion/routes/result_parts.hpp"
#include "recursion/routes/routes_of_groups.hpp"
#include "recursion/routes/tree_paths.hpp"

namespace treeline {
namespace {

using PlaceList = std::vector<std::int16_t>;

/// Arrays of numbers of joints or links side by side, one array a component, each with a place for
/// every freedom and as many more as make a multiple of eight.
template <class Number>
class SideBySide {
 public:
  SideBySide(std::size_t components, std::size_t velocities)
      : stride_(static_cast<std::size_t>(core::in_eights(static_cast<int>(velocities)))),
        values_(components * stride_, Number(0.0)) {}
  Number& at(std::size_t component, std::size_t place) {
    return values_[component * stride_ + place];
  }
  [[nodiscard]] const std::vector<Number>& values() const { return values_; }

 private:
  std::size_t stride_;
  std::vector<Number> values_;
};

/// The place that stands for a link: that of its joint's last freedom.
int place_of(const TreeLink<Expression>& link) {
  return link.v_index + link.velocities() - 1;
}

int parent_place(const Tree<Expression>& tree, const TreeLink<Expression>& link) {
  return link.parent < 0 ? -1 : place_of(tree.links[static_cast<std::size_t>(link.parent)]);
}

std::array<Expression, 10> numbers_of(const TreeInertia<Expression>& inertia) {
  const auto& [mass, h, Sigma, J] = inertia;
  return {mass, h.x, h.y, h.z, Sigma.xx, Sigma.yy, Sigma.zz, Sigma.xy, Sigma.xz, Sigma.yz};
}

bool has_constant_numbers(const TreeLink<Expression>& link) {
  const auto numbers = numbers_of(link.inertia);
  return link.multiplier.is_constant() && link.drive.inertia.is_constant() &&
         link.drive.stiffness.is_constant() &&
         std::all_of(numbers.begin(), numbers.end(),
                     [](const Expression& number) { return number.is_constant(); });
}

bool floats(const Tree<Expression>& tree) {
  return tree.links.front().is_floating();
}

/// The constants of links and joints.
void list_constants(const Tree<Expression>& tree, Ending& ending) {
  const auto n = static_cast<std::size_t>(tree.nv);
  SideBySide<double> links(10, n);
  SideBySide<double> joints(2, n);
  for (const TreeLink<Expression>& link : tree.links) {
    const auto place = static_cast<std::size_t>(place_of(link));
    const auto numbers = numbers_of(link.inertia);
    for (std::size_t k = 0; k < numbers.size(); ++k) links.at(k, place) = numbers[k].constant();
    if (link.is_floating()) continue;
    joints.at(link.is_angular(0) ? 0 : 1, place) = link.multiplier.constant();
  }
  ending.tables.push_back({"links", links.values()});
  ending.tables.push_back({"joints", joints.values()});
}

/// What a part of the joints' drives adds to the diagonal of a matrix.
void append_drives(const Tree<Expression>& tree, Expression TreeDrive<Expression>::*part,
                   std::vector<double>& to) {
  std::vector<double> parts(static_cast<std::size_t>(tree.nv));
  for (const TreeLink<Expression>& link : tree.links) {
    parts[static_cast<std::size_t>(place_of(link))] = (link.drive.*part).constant();
  }
  to.insert(to.end(), parts.begin(), parts.end());
}

/// What rotors add to the diagonal of M, and springs to that of the derivative by displacements.
Table list_drives(const Tree<Expression>& tree) {
  std::vector<double> drives;
  append_drives(tree, &TreeDrive<Expression>::inertia, drives);
  append_drives(tree, &TreeDrive<Expression>::stiffness, drives);
  return {"drives", drives};
}

/// The place before each, -1 for none. The freedoms of a floating base that stand for no link carry
/// each other.
PlaceList list_parents(const Tree<Expression>& tree) {
  PlaceList parents(static_cast<std::size_t>(tree.nv), -1);
  for (const TreeLink<Expression>& link : tree.links) {
    parents[static_cast<std::size_t>(place_of(link))] =
        static_cast<std::int16_t>(parent_place(tree, link));
  }
  return parents;
}

/// Whether one of two freedoms carries the other.
bool are_related(const Ending& ending, const PlaceList& parents, int i, int j) {
  int at = std::max(i, j);
  const int other = std::min(i, j);
  if (ending.floats && other < 6) return true;
  while (at > other) at = parents[static_cast<std::size_t>(at)];
  return at == other;
}

/// Lists the blocks of a matrix, see `TlBlocks` of `runtime/emitted/common_frame.h`.
class BlockList {
 public:
  BlockList(const PlaceList& parents, const Ending& ending) : parents_(parents), ending_(ending) {
    const int end = core::in_eights(ending.velocities);
    for (int row = 0; row < end; row += 8) {
      for (int column = end - 8; column >= 0; column -= 8) add(row, column);
    }
  }

  void append_to(std::vector<Table>& tables) const {
    tables.push_back({"blocks", blocks_});
    tables.push_back({"keeps", keeps_});
    // Rows are read eight wide, also by compilers that look at blocks which are not there.
    tables.push_back({"kept", kept_.empty() ? std::vector<double>(8) : kept_});
  }

 private:
  /// Places beyond the last stand for nothing: whatever their entries are, they are not written.
  [[nodiscard]] bool counts(int i, int j) const {
    const int n = ending_.velocities;
    return i >= n || j >= n || are_related(ending_, parents_, i, j);
  }

  [[nodiscard]] int count_in_row(int i, int column) const {
    int count = 0;
    for (int j = column; j < std::min(column + 8, ending_.velocities); ++j) {
      count += i < ending_.velocities && counts(i, j) ? 1 : 0;
    }
    return count;
  }

  void add(int row, int column) {
    int all = 0;
    bool mixed = false;
    for (int i = row; i < row + 8; ++i) {
      all += count_in_row(i, column);
      for (int j = column; j < column + 8; ++j) mixed = mixed || !counts(i, j);
    }
    const int kind = all == 0 ? -2 : mixed ? static_cast<int>(keeps_.size()) : -1;
    blocks_.insert(blocks_.end(),
                   {static_cast<std::int16_t>(row), static_cast<std::int16_t>(column),
                    static_cast<std::int16_t>(kind)});
    if (kind < 0) return;
    for (int i = row; i < row + 8; ++i) keeps_.push_back(place_factors(i, column));
  }

  /// Where the factors of a row's entries begin in `kept_`.
  std::int16_t place_factors(int i, int column) {
    std::array<double, 8> factors{};
    for (int j = 0; j < 8; ++j) {
      factors[static_cast<std::size_t>(j)] = counts(i, column + j) ? 1 : 0;
    }
    std::size_t at = 0;
    const auto is_there = [&] {
      return std::equal(factors.begin(), factors.end(),
                        kept_.begin() + static_cast<std::ptrdiff_t>(at));
    };
    while (at < kept_.size() && !is_there()) at += 8;
    if (at == kept_.size()) kept_.insert(kept_.end(), factors.begin(), factors.end());
    return static_cast<std::int16_t>(at);
  }

  const PlaceList& parents_;
  const Ending& ending_;
  PlaceList blocks_, keeps_;
  std::vector<double> kept_;
};

/// Rotations and origins of all links in the common frame: that of a floating base, or the world.
void place_links(const Trace& trace, Ending& ending) {
  const Tree<Expression>& tree = trace.tree;
  std::vector<JointTransform<Expression>> X = trace.X;
  if (ending.floats) X.front() = {};
  const auto poses = world_poses(tree, X);
  const auto n = static_cast<std::size_t>(tree.nv);
  SideBySide<Expression> R(9, n);
  SideBySide<Expression> p(3, n);
  for (std::size_t i = 0; i < tree.links.size(); ++i) {
    const auto place = static_cast<std::size_t>(place_of(tree.links[i]));
    const Matrix3<Expression>& own = poses[i].R;
    const Vector3<Expression>* rows[] = {&own.row_x, &own.row_y, &own.row_z, &poses[i].p};
    for (std::size_t row = 0; row < 4; ++row) {
      const Expression parts[] = {rows[row]->x, rows[row]->y, rows[row]->z};
      for (std::size_t k = 0; k < 3; ++k) {
        (row < 3 ? R.at(3 * row + k, place) : p.at(k, place)) = parts[k];
      }
    }
  }
  ending.lines.results.push_back(vector_result("R", "", R.values()));
  ending.lines.results.push_back(vector_result("p", "", p.values()));
}

/// What every ending in a common frame has, with work space of so many arrays.
Ending begin_ending(const Trace& trace, Routine routine, std::size_t arrays) {
  Ending ending;
  ending.routine = routine;
  ending.velocities = trace.tree.nv;
  ending.floats = floats(trace.tree);
  ending.work = arrays * static_cast<std::size_t>(core::in_eights(trace.tree.nv));
  return ending;
}

void list_tables(const Tree<Expression>& tree, Table of_drives, Ending& ending) {
  list_constants(tree, ending);
  ending.tables.push_back(std::move(of_drives));
  const PlaceList parents = list_parents(tree);
  ending.tables.push_back({"parents", parents});
  BlockList(parents, ending).append_to(ending.tables);
}

/// The acceleration that stands for gravity, in the axes of the common frame.
Vector3<Expression> find_up(const Trace& trace) {
  const Vector3<Expression> up = -trace.tree.gravity;
  return floats(trace.tree) ? trace.X.front().to_child(up) : up;
}

/// Rates and their changes, slopes of friction, gravity.
std::vector<Expression> list_rates(const Trace& trace, const std::vector<Expression>& qd,
                                   const std::vector<Expression>& changes) {
  std::vector<Expression> rates = qd;
  rates.insert(rates.end(), changes.begin(), changes.end());
  std::vector<Expression> slopes(qd.size(), Expression(0.0));
  for (const TreeLink<Expression>& link : trace.tree.links) {
    const auto at = static_cast<std::size_t>(place_of(link));
    if (has_friction(link.drive)) slopes[at] = friction_slope<Expression>(link.drive, qd[at]);
  }
  rates.insert(rates.end(), slopes.begin(), slopes.end());
  const Vector3<Expression> up = find_up(trace);
  rates.insert(rates.end(), {up.x, up.y, up.z});
  return rates;
}

}  // namespace

bool suits_common_frame(const Tree<Expression>& tree) {
  // Places of factors are listed as numbers of 16 bits.
  if (tree.links.empty() || tree.has_mimics || tree.nv > 176) return false;
  std::vector<int> parents(static_cast<std::size_t>(tree.nv), -1);
  int last = -1;
  for (const TreeLink<Expression>& link : tree.links) {
    const bool first = &link == &tree.links.front();
    const bool own = link.has_one_coordinate() || (first && link.is_floating());
    const int parent = parent_place(tree, link);
    int at = last;
    while (at > parent) at = parents[static_cast<std::size_t>(at)];
    const bool depth_first = at == parent && place_of(link) > last;
    if (!own || link.spins || !depth_first || !has_constant_numbers(link)) return false;
    last = place_of(link);
    parents[static_cast<std::size_t>(last)] = parent;
  }
  return true;
}

Ending end_with_mass_matrix(const Trace& trace) {
  Ending ending = begin_ending(trace, Routine::mass_matrix, 22);
  ending.results = {{"M", trace.tree.nv, trace.tree.nv, "joint-space inertia"}};
  std::vector<double> rotors;
  append_drives(trace.tree, &TreeDrive<Expression>::inertia, rotors);
  list_tables(trace.tree, {"rotors", rotors}, ending);
  place_links(trace, ending);
  return ending;
}

Ending end_with_force_derivatives(const Trace& trace) {
  Ending ending = begin_ending(trace, Routine::force_derivatives, 85);
  const int n = trace.tree.nv;
  ending.results = {{"dtau_dq", n, n, by_displacements(*trace.mechanism)},
                    {"dtau_dqd", n, n, "by qd"},
                    {"dtau_dqdd", n, n, "by qdd: M"}};
  list_tables(trace.tree, list_drives(trace.tree), ending);
  place_links(trace, ending);
  ending.lines.results.push_back(
      vector_result("rates", "", list_rates(trace, trace.qd(), trace.qdd())));
  return ending;
}

Ending end_with_acceleration_derivatives(const Trace& trace) {
  const Tree<Expression>& tree = trace.tree;
  const int n = tree.nv;
  const PlaceList parents = list_parents(tree);
  Ending ending = begin_ending(trace, Routine::acceleration_derivatives, 0);
  const auto related = [&](int i, int j) { return are_related(ending, parents, i, j); };
  const TreePaths paths(n, related);
  ending.path = paths.row_length();
  const int places = core::in_eights(n);
  ending.work = static_cast<std::size_t>((133 + 2 * ending.path) * places + 24 * ending.path + 8);
  ending.results = {{"dqdd_dq", n, n, by_displacements(*trace.mechanism)},
                    {"dqdd_dqd", n, n, "by qd"},
                    {"dqdd_dtau", n, n, "by tau: M^-1"}};
  list_tables(tree, list_drives(tree), ending);
  paths.append_to(ending.tables, related);
  paths.append_paths_to(ending.tables);
  place_links(trace, ending);
  std::vector<Expression> taken(static_cast<std::size_t>(tree.nv), Expression(0.0));
  add_drive_forces<Expression>(tree, trace.X, {trace.qd(), {}}, taken);
  std::vector<Expression> net = trace.tau();
  for (std::size_t i = 0; i < net.size(); ++i) net[i] = net[i] - taken[i];
  ending.lines.results.push_back(vector_result("rates", "", list_rates(trace, trace.qd(), net)));
  return ending;
}

}  // namespace treeline
