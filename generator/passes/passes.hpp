#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "program/program.hpp"

namespace treeline {

/// Puts the nodes of a traced program into an order that depends only on the program: depth-first
/// from the results, left operands first. This is needed because C++ leaves the order in which a
/// trace builds nodes to the compiler. Nodes that no result needs are removed. x y and y x become
/// one node, and expressions that simplify as a consequence are simplified.
Program canonicalize(const Program& program);

/// Removes the nodes that no result needs. The others keep their order.
Program eliminate_dead(const Program& program);

/// Takes common factors out of sums: a c + b c -> (a + b) c, which saves one product for each term
/// but the first. A sum is considered as a whole, across all nodes that it consists of, as long as
/// these and their products have no other use; so nothing is computed twice. The factor that most
/// terms share is taken out first.
Program factor_sums(const Program& program);

/// Returns `order` with operations moved forward so that they do not wait for each other, as a list
/// scheduler would do with the latencies of current cores: among the next operations that are
/// ready, the one with the longest way to a result goes first. Nodes of a pack stay together, and
/// the first `head` nodes keep their places.
std::vector<std::uint32_t> interleave(const Program& program, std::span<const std::uint32_t> order,
                                      std::size_t head);

/// Finds operations that can share registers of `program.graph.lane_width()` lanes and lists them
/// in `packs`; the graph does not change. The search starts from the groups that the trace aligned
/// and follows their operands as long as all lanes have the same operation (superword-level
/// parallelism, Larsen & Amarasinghe 2000). A pack stays if it saves more operations than are
/// needed to bring scalars into lanes and take them out again, and if no two packs wait for each
/// other.
Program pack_lanes(const Program& program);

/// Puts the live nodes into the order in which they are computed: first all angles, then their
/// sines and cosines side by side (evaluated together, in lanes), then depth-first from the
/// results, starting with the operand that needs more registers. So a value is computed shortly
/// before its use, and one limb is finished, outward and inward, before the next begins. The order
/// of tracing would compute all limbs outward first and keep every intermediate value alive until
/// the way back. At last neighbours are interleaved, see `interleave`.
Program schedule(const Program& program);

/// Computes once what several sums, or several products, have in common: the pair a + b in (a + b)
/// + c and (a + d) + b. Sums and products are considered as a whole, across all nodes that make
/// them up, as long as these have no other use. The most frequent pair is taken first, until none
/// occurs twice (Breuer 1969).
Program share_pairs(const Program& program);

/// Replaces sines and cosines of joint angles by inputs `sin_q[i]` and `cos_q[i]`, which follow `q`
/// in the list of arguments. Those of sums of angles and constants follow from the addition
/// theorems. This serves scenes with `sin_cos: given`: a controller that calls several functions in
/// one state, or whose encoders deliver sines and cosines, computes none twice. Sines and cosines
/// of multiples of an angle (mimic joints with a factor) are still computed.
Program take_sines(const Program& program);

/// Adds sin_q and cos_q to the arguments where the program reads them.
void declare_sines(Program& program);

/// Effect of one pass: the operations that the results need, and the nodes of the graph including
/// dead ones, before and after.
struct PassReport {
  std::string pass;
  OperationCount before, after;
  std::size_t nodes_before = 0, nodes_after = 0;
};

/// Reduces a traced program to the operations that are emitted: removes dead code, finds cheaper
/// forms, forms packs of lanes. The program's cost is final after this. Each pass appends a line to
/// `log`.
Program reduce_operations(Program program, std::vector<PassReport>& log);

/// Puts the operations of a program into the order of emission. Only the chosen route needs this.
Program put_in_order(const Program& program, std::vector<PassReport>& log);

/// One line of the log: `inverse_dynamics: eliminate_dead 2600 -> 2219 flops, 3500 -> 2800 nodes`
std::string to_string(const std::string& function, const PassReport& report);

/// Length in cycles of the longest chain of operations in which each waits for the previous one.
/// Latencies are those of current x86 cores (Fog, Instruction tables; Zen 3 to 5, Ice Lake): 3 for
/// an addition or a product, 13 for a division. Sines and cosines count nothing, because every
/// chain begins with them.
int critical_path(const Program& program);

/// Finds operations that isomorphic limbs share. Exchanging each limb of a family for the next one,
/// with its inputs and constants, maps an operation of one limb to the same operation of the next.
/// Each group holds the live operations that follow one another in this way, ordered by limb, with
/// node 0 where a limb lacks one. Its length is the number of limbs, rounded up to a power of two,
/// and at most the graph's number of lanes.
std::vector<LanePack> find_isomorphic_operations(const Program& program);

}  // namespace treeline
