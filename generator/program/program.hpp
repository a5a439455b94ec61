#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "program/expression.hpp"
#include "program/route_id.hpp"

namespace treeline {

/// An argument of an emitted function: a vector (cols == 1) or a row-major matrix.
struct Argument {
  std::string name;  ///< `qdd`
  int rows = 0;
  int cols = 1;
  std::string meaning;  ///< with units and frame, for the contract: "joint accelerations, rad/s^2"
};

/// An argument that the function writes; `values` are row-major, rows*cols of them.
struct Result {
  Argument argument;
  std::vector<Expression> values;
};

/// One entry of one result.
struct ResultPlace {
  std::size_t result = 0;
  std::size_t entry = 0;
};

/// Nodes that share a register, by lane; node 0 is an empty lane. All are the same operation.
using LanePack = std::vector<std::uint32_t>;

struct TaskLaw;

/// One function as an expression graph. Inputs of the graph are named `argument[i]`.
struct Program {
  std::string name;      ///< `inverse_dynamics`
  std::string equation;  ///< "tau = M(q) qdd + b(q, qd) + g(q)"
  RouteId route;         ///< how it is computed
  std::vector<Argument> arguments;
  std::vector<Result> results;
  Graph graph;
  std::vector<LanePack> packs;  ///< disjoint; see `pack_lanes`
  int lane_moves = 0;           ///< values brought into lanes or taken out of them
  /// What to compute first, in this order, so that values are used soon after they are made; what
  /// is not listed follows in the order of the results.
  std::vector<ResultPlace> order;
  /// How rows of the task yield near singularities; null: they do not, or there is no task.
  std::shared_ptr<const TaskLaw> law;
  std::string singular;  ///< what it answers at singularities of the task, a sentence; may be empty
};

/// Operations that the results need, as emitted; sin and cos are counted apart.
struct OperationCount {
  int add = 0, mul = 0, div = 0, sin_cos = 0;  ///< add counts + and -; sin_cos counts angles
  [[nodiscard]] int flops() const { return add + mul + div; }
};

}  // namespace treeline
