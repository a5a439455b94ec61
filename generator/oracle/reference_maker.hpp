#pragma once

#include <memory>
#include <vector>

#include "interpreter/digits50.hpp"
#include "interpreter/task_law.hpp"
#include "oracle/graph_run.hpp"
#include "oracle/reference.hpp"
#include "oracle/result_sizes.hpp"
#include "recursion/methods/task_law.hpp"

namespace treeline {

/// Makes the references of all chosen functions, state by state. Equal seeds give equal
/// references. May be used from several threads at once.
class ReferenceMaker {
 public:
  /// `chosen` must outlive this object.
  ReferenceMaker(const Robot& robot, const Scene& scene, const ChosenFunctions& chosen,
                 std::uint64_t seed);

  /// The functions in the order of the references: `all_callable`.
  [[nodiscard]] const std::vector<GeneratedFunction>& functions() const { return functions_; }
  /// Makes state `index` with all its references.
  [[nodiscard]] StateReference make(int index) const;
  /// Makes the references of a state from elsewhere, which has every argument of the functions.
  [[nodiscard]] StateReference make(State state) const;
  /// Makes state `index` without the 50 digits, in a small part of the time: `high` and the sizes
  /// come from the interpreter in Real, and `interpreter_error` is unknown.
  [[nodiscard]] StateReference estimate(int index) const;
  /// Replaces the estimated reference of function `i` at this state by the one that `make` gives.
  void complete(std::size_t i, const State& state, FunctionReference& estimated) const;

 private:
  enum class Digits { in_real, fifty };

  [[nodiscard]] StateReference make(State state, Digits digits) const;
  [[nodiscard]] bool shares_reference(std::size_t i) const;
  void compose_graph(StateReference& made) const;
  [[nodiscard]] FunctionReference interpret_at(std::size_t i, const State& state,
                                               const ResultSizes& sizes, Digits digits) const;
  [[nodiscard]] bool is_regular(const ResultSizes& sizes) const;
  [[nodiscard]] bool stays_finite(Function function, const State& state, const ResultSizes& sizes,
                                  const interpreter::TaskLaw<interpreter::Digits50>& law) const;
  [[nodiscard]] std::vector<double> interpret_in_real(
      Function function, const State& state,
      const interpreter::TaskLaw<interpreter::Digits50>& law) const;

  std::vector<GeneratedFunction> functions_;
  std::size_t plain_;           ///< number of functions of a single state
  std::vector<GraphRun> runs_;  ///< by function
  /// Task law for the sizes of the results, by function.
  std::vector<std::shared_ptr<const TaskLaw>> size_laws_;
  Real real_;
  Subject<interpreter::Digits50> exact_;
  Subject<float> single_;
  StateSpace space_;
};

}  // namespace treeline
