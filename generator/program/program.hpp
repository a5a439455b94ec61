#pragma once

#include <cstddef>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "program/expression.hpp"
#include "program/route_id.hpp"

namespace treeline {

/// An argument of an emitted function: a vector (cols == 1) or a row-major matrix.
struct Argument {
  std::string name;  ///< for instance `qdd`
  int rows = 0;
  int cols = 1;
  std::string meaning;  ///< with units and frame, for the contract: "joint accelerations, rad/s^2"
};

/// An argument that the function writes. `values` are row-major, rows * cols elements.
struct Result {
  Argument argument;
  std::vector<Expression> values;
};

/// Place of one entry of one result.
struct ResultPlace {
  std::size_t result = 0;
  std::size_t entry = 0;
};

/// Nodes that share a register, by lane. Node 0 is an empty lane. All have the same operation.
using LanePack = std::vector<std::uint32_t>;

struct TaskLaw;
struct LinkLoops;
struct Ending;

/// Names of a robot's constants, by their sizes: `mass_3`. Sizes that several constants have are
/// left out.
using ConstantNames = std::map<double, std::string>;

/// One function as an expression graph. Inputs of the graph are named `argument[i]`.
struct Program {
  std::string name;      ///< for instance `inverse_dynamics`
  std::string equation;  ///< "tau = M(q) qdd + b(q, qd) + g(q)"
  RouteId route;         ///< how it is computed
  std::vector<Argument> arguments;
  std::vector<Result> results;
  Graph graph;
  std::vector<LanePack> packs;  ///< disjoint; see `pack_lanes`
  int lane_moves = 0;           ///< number of values brought into lanes or taken out
  /// Entries to compute first, in this order, so that values are used soon after they are computed.
  /// Other entries follow in the order of the results.
  std::vector<ResultPlace> order;
  /// Law by which rows of the task are relaxed near singularities. Null if there is no task or none
  /// of its rows is relaxed.
  std::shared_ptr<const TaskLaw> law;
  std::string singular;  ///< a sentence on the results at singularities of the task; may be empty
  std::shared_ptr<const ConstantNames> constants;  ///< null where names are not kept
  /// Loops over a table of links, of which the graph is the trace; null if the function has none.
  std::shared_ptr<const LinkLoops> loops;
  /// The call of a routine behind straight lines, whose operations the graph has too; null if the
  /// function has none.
  std::shared_ptr<const Ending> ending;
};

/// Number of operations that the results need, as emitted. Sines and cosines are counted
/// separately.
struct OperationCount {
  int add = 0, mul = 0, div = 0, sin_cos = 0;  ///< add counts + and -; sin_cos counts angles
  [[nodiscard]] int flops() const { return add + mul + div; }
};

}  // namespace treeline
