#pragma once

#include <memory>
#include <vector>

#include "interpreter/digits50.hpp"
#include "interpreter/task_law.hpp"
#include "oracle/graph_run.hpp"
#include "oracle/reference.hpp"
#include "oracle/result_sizes.hpp"
#include "recursion/task_law.hpp"

namespace treeline {

/// Makes the references of all functions of a generation, state by state; the same for the same
/// seed. May be used from several threads at once.
class ReferenceMaker {
 public:
  /// `generation` must outlive it.
  ReferenceMaker(const Robot& robot, const Scene& scene, const Generation& generation,
                 std::uint64_t seed);

  /// In the order of the references: `all_callable`.
  [[nodiscard]] const std::vector<GeneratedFunction>& functions() const { return functions_; }
  /// State `index` with all references.
  [[nodiscard]] StateReference make(int index) const;
  /// The same without the 50 digits, for a small part of the time: `high` is what the interpreter
  /// gives in Real, sizes are found by that, and `interpreter_error` is not known.
  [[nodiscard]] StateReference estimate(int index) const;
  /// What was estimated of function `i` at a state becomes what `make` gives.
  void complete(std::size_t i, const State& state, FunctionReference& estimated) const;

 private:
  enum class Digits { in_real, fifty };

  [[nodiscard]] StateReference make(int index, Digits digits) const;
  void compose_graph(StateReference& made) const;
  [[nodiscard]] FunctionReference interpret_at(std::size_t i, const State& state,
                                               const ResultSizes& sizes, Digits digits) const;
  [[nodiscard]] bool stays_finite(Function function, const State& state, const ResultSizes& sizes,
                                  const interpreter::TaskLaw<interpreter::Digits50>& law) const;
  [[nodiscard]] std::vector<double> interpret_in_real(
      Function function, const State& state,
      const interpreter::TaskLaw<interpreter::Digits50>& law) const;

  std::vector<GeneratedFunction> functions_;
  std::size_t plain_;           ///< so many of them are of one state
  std::vector<GraphRun> runs_;  ///< of each function
  /// Of each function, by which its sizes are found.
  std::vector<std::shared_ptr<const TaskLaw>> size_laws_;
  Real real_;
  Subject<interpreter::Digits50> exact_;
  Subject<float> single_;
  StateSpace space_;
};

}  // namespace treeline
