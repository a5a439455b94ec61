#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <unordered_map>
#include <utility>
#include <vector>

#include "passes/lane_operands.hpp"
#include "passes/lanes.hpp"
#include "passes/pack_cycles.hpp"
#include "passes/passes.hpp"
#include "passes/rebuild.hpp"

namespace treeline {
namespace {

bool is_arithmetic(Op op) {
  return op == Op::add || op == Op::sub || op == Op::mul || op == Op::div || op == Op::neg;
}

class Packer {
 public:
  /// `isomorphic`: see `find_isomorphic_operations`.
  Packer(const Program& program, const std::vector<LanePack>& isomorphic)
      : program_(program),
        nodes_(program.graph.nodes()),
        isomorphic_(isomorphic),
        live_(find_live(program)),
        pack_of_(nodes_.size(), kNoPack) {}

  /// Order of packing: first the columns that the trace aligned, or operations of isomorphic limbs.
  enum class First { columns, limbs };

  void run(First first) {
    if (first == First::columns) {
      pack_columns();
      resolve_packs();
    }
    pack_isomorphic();
    resolve_packs();
    if (first == First::limbs) {
      pack_columns();
      resolve_packs();
    }
    pack_isomorphic();  // operations of packs that were taken apart
    resolve_packs();
  }

  /// Number of instructions that the program takes.
  [[nodiscard]] int count_instructions() const {
    int count = count_moves();
    for (const LanePack& pack : packs_) {
      count += pack.empty() ? 0 : 1;
    }
    for (std::size_t i = 0; i < nodes_.size(); ++i) {
      count += live_[i] && is_arithmetic(nodes_[i].op) && pack_of_[i] == kNoPack ? 1 : 0;
    }
    return count;
  }

  void deliver(Program& packed) {
    packed.lane_moves = count_moves();
    std::erase_if(packs_, [](const LanePack& lanes) { return lanes.empty(); });
    packed.packs = std::move(packs_);
  }

 private:
  void pack_columns() {
    const auto width = static_cast<std::size_t>(program_.graph.lane_width());
    for (std::size_t i = 0; i < program_.graph.lane_group_count(); ++i) {
      const Graph::LaneGroup group = program_.graph.lane_group(i);
      for (std::size_t first = 0; first < group.size(); first += width) {
        Lanes lanes(width);
        std::copy_n(group.begin() + static_cast<std::ptrdiff_t>(first),
                    std::min(width, group.size() - first), lanes.begin());
        pack(lanes, 2);
      }
    }
  }

  void pack_isomorphic() {
    for (const LanePack& group : isomorphic_) {
      add(Lanes(group), 2);
    }
  }

  /// Taking packs apart makes no cycle and no loss that is left, so there is nothing to do unless
  /// packs were added.
  void resolve_packs() {
    if (std::exchange(resolved_, packs_.size()) == packs_.size()) return;
    dissolve_cycles();
    while (dissolve_losses()) {
    }
  }

  /// Keeps in `lanes` only what may be computed together: live nodes of one operation that are not
  /// packed yet.
  void keep_alike(Lanes& lanes) const {
    std::array<int, kOperations.size()> votes{};
    for (auto* lane = lanes.begin(); lane != lanes.end(); ++lane) {
      const std::uint32_t node = *lane;
      const Op op = nodes_[node].op;
      if (!live_[node] || !is_arithmetic(op) || pack_of_[node] != kNoPack ||
          std::find(lanes.begin(), lane, node) != lane) {
        *lane = kNoNode;
      } else {
        ++votes[static_cast<std::size_t>(op)];
      }
    }
    const auto winner =
        static_cast<Op>(std::max_element(votes.begin(), votes.end()) - votes.begin());
    for (std::uint32_t& node : lanes) {
      if (node != kNoNode && nodes_[node].op != winner) {
        node = kNoNode;
      }
    }
  }

  /// Makes a pack of the nodes in `lanes` that can share an operation. Returns false if these are
  /// fewer than `fewest`.
  bool add(Lanes lanes, int fewest) {
    keep_alike(lanes);
    if (count_lanes(lanes) < fewest) {
      return false;
    }
    for (const std::uint32_t node : lanes) {
      if (node != kNoNode) pack_of_[node] = static_cast<int>(packs_.size());
    }
    Lanes left(lanes.size()), right(lanes.size());
    lane_operands(program_.graph, lanes, left, right);
    readings_.push_back({number_of(lanes), number_of(left), number_of(right)});
    packs_.emplace_back(lanes.begin(), lanes.end());
    return true;
  }

  /// Number that identifies these lanes, whether a pack consists of them or reads them.
  int number_of(const Lanes& lanes) {
    const auto [found, is_new] = numbers_.try_emplace(lanes, static_cast<int>(readable_.size()));
    if (is_new) {
      const Lanes values = distinct(lanes);
      const bool constant = std::all_of(values.begin(), values.end(), [&](std::uint32_t node) {
        return nodes_[node].op == Op::constant;
      });
      readable_.push_back({lanes, values, constant});
    }
    return found->second;
  }
  [[nodiscard]] const auto& readable(int number) const {
    return readable_[static_cast<std::size_t>(number)];
  }

  void pack(const Lanes& lanes, int fewest) {
    if (!add(lanes, fewest)) {
      return;
    }
    const Reading reading = readings_.back();
    for (const int number : {reading.a, reading.b}) {
      const Lanes operands = readable(number).lanes;
      const bool in_groups = std::any_of(operands.begin(), operands.end(), [&](std::uint32_t n) {
        return program_.graph.lane_group_of(n) >= 0;
      });
      if (readable(number).values.size() > 1 && !in_groups) {
        pack(operands, 3);
      }
    }
  }

  /// Number of instructions that bring these operands into lanes: none for one scalar in all lanes,
  /// for constants, and for the lanes of one pack in place; one for a permutation of at most two
  /// packs; otherwise one per value.
  [[nodiscard]] int gather_cost(int number) const {
    const auto& [operands, values, constant] = readable(number);
    if (values.size() == 1) {
      return pack_of_[values[0]] == kNoPack ? 0 : 1;
    }
    if (constant) {
      return 0;
    }
    const auto each = static_cast<int>(values.size());
    std::array<int, 2> packs{kNoPack, kNoPack};
    for (const std::uint32_t node : values) {
      const int pack = pack_of_[node];
      if (pack == kNoPack) return each;
      if (packs[0] == kNoPack) packs[0] = pack;
      if (pack == packs[0]) continue;
      if (packs[1] != kNoPack && pack != packs[1]) return each;
      packs[1] = pack;
    }
    return packs[1] == kNoPack &&
                   stands_in_place(operands, packs_[static_cast<std::size_t>(packs[0])])
               ? 0
               : 1;
  }

  /// Takes apart packs that wait for each other, directly or through scalars.
  void dissolve_cycles();
  /// Takes apart the packs that cost more than they save. Returns whether there were any.
  bool dissolve_losses();

  void dissolve(std::size_t index) {
    for (const std::uint32_t node : packs_[index]) {
      if (node != kNoNode) {
        pack_of_[node] = kNoPack;
      }
    }
    packs_[index].clear();
  }

  /// Returns for every node whether scalar code reads it.
  [[nodiscard]] Marks find_scalar_reads() const;
  [[nodiscard]] int count_extractions(const LanePack& pack, const Marks& read) const;

  /// Number of packs that read certain lanes as they stand, indexed by `number_of` these lanes.
  using Readers = std::vector<int>;
  [[nodiscard]] Readers find_readers() const;
  /// Number of instructions that bring values into lanes or take them out.
  [[nodiscard]] int count_moves() const;
  /// Number of instructions added by taking pack `p` apart; negative if that saves some.
  [[nodiscard]] int cost_of_dissolving(std::size_t p, const Marks& read,
                                       const Readers& readers) const;

  const Program& program_;
  const std::vector<Node>& nodes_;
  const std::vector<LanePack>& isomorphic_;
  Marks live_;
  std::vector<int> pack_of_;
  std::vector<LanePack> packs_;
  std::size_t resolved_ = 0;  // number of packs when they were resolved last
  struct Reading {
    int own = 0, a = 0, b = 0;  ///< numbers of the pack's own lanes and of those that it reads
  };
  std::vector<Reading> readings_;  // by pack
  std::unordered_map<Lanes, int, HashOfLanes> numbers_;
  struct Readable {
    Lanes lanes;
    Lanes values;           ///< without repetition
    bool constant = false;  ///< all values are constants
  };
  std::vector<Readable> readable_;  // by number
};

Marks Packer::find_scalar_reads() const {
  Marks read(nodes_.size(), 0);
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    const int operands = operation(nodes_[i].op).operands;
    if (live_[i] && pack_of_[i] == kNoPack && operands >= 1) {
      read[nodes_[i].a] = 1;
      read[operands == 2 ? nodes_[i].b : nodes_[i].a] = 1;
    }
  }
  return read;
}

int Packer::count_extractions(const LanePack& pack, const Marks& read) const {
  return static_cast<int>(std::count_if(pack.begin(), pack.end(), [&](std::uint32_t node) {
    return node != kNoNode && read[node] != 0;
  }));
}

Packer::Readers Packer::find_readers() const {
  Readers readers(readable_.size(), 0);
  for (std::size_t p = 0; p < packs_.size(); ++p) {
    if (!packs_[p].empty()) {
      ++readers[static_cast<std::size_t>(readings_[p].a)];
      ++readers[static_cast<std::size_t>(readings_[p].b)];
    }
  }
  return readers;
}

int Packer::cost_of_dissolving(std::size_t p, const Marks& read, const Readers& readers) const {
  const LanePack& pack = packs_[p];
  int cost = count_lanes(pack) - 1 - count_extractions(pack, read);
  for (const int number : {readings_[p].a, readings_[p].b}) {
    const int gather = gather_cost(number);
    // Operands that several packs share are gathered once, so the cost is saved only by the last
    // reader.
    cost -= readers[static_cast<std::size_t>(number)] == 1 ? gather : 0;
    const Lanes& values = readable(number).values;
    if (gather == 0 && values.size() > 1) {  // scalar code will read these values
      for (const std::uint32_t node : values) {
        cost += pack_of_[node] != kNoPack && read[node] == 0 ? 1 : 0;
      }
    }
  }
  const bool read_in_place = readers[static_cast<std::size_t>(readings_[p].own)] > 0;
  return cost + (read_in_place ? count_lanes(pack) : 0);
}

int Packer::count_moves() const {
  const Marks read = find_scalar_reads();
  int moves = 0;
  for (const LanePack& pack : packs_) {
    moves += count_extractions(pack, read);
  }
  const Readers readers = find_readers();
  for (std::size_t number = 0; number < readers.size(); ++number) {
    moves += readers[number] > 0 ? gather_cost(static_cast<int>(number)) : 0;
  }
  return moves;
}

bool Packer::dissolve_losses() {
  const Marks read = find_scalar_reads();
  const Readers readers = find_readers();
  bool found = false;
  for (std::size_t p = 0; p < packs_.size(); ++p) {
    if (!packs_[p].empty() && cost_of_dissolving(p, read, readers) < 0) {
      dissolve(p);
      found = true;
    }
  }
  return found;
}

void Packer::dissolve_cycles() {
  PackCycles cycles(nodes_, packs_, pack_of_);
  while (const auto pack = cycles.next()) {
    dissolve(*pack);
  }
}

}  // namespace

Program pack_lanes(const Program& program) {
  Program packed = program;
  if (program.graph.lane_width() == 1) {
    return packed;
  }
  const std::vector<LanePack> isomorphic = find_isomorphic_operations(program);
  Packer best(program, isomorphic);
  best.run(Packer::First::columns);
  if (!program.graph.limb_inputs().empty()) {
    Packer limbs_first(program, isomorphic);
    limbs_first.run(Packer::First::limbs);
    if (limbs_first.count_instructions() < best.count_instructions()) {
      limbs_first.deliver(packed);
      return packed;
    }
  }
  best.deliver(packed);
  return packed;
}

}  // namespace treeline
