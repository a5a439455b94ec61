#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "choice/choose_functions.hpp"
#include "choice/function_mechanisms.hpp"
#include "choice/run_routes.hpp"
#include "description/robot.hpp"
#include "description/scene.hpp"
#include "mechanism/mechanism.hpp"
#include "oracle/subject.hpp"
#include "program/program.hpp"

namespace treeline {

/// A function as callers without its code see it, and the law by which rows of its task yield.
struct InterpretedFunction {
  Function function{};
  std::string equation;
  std::vector<Argument> arguments;
  std::vector<Argument> results;
  std::shared_ptr<const TaskLaw> law;  ///< null where no row yields
};

/// Numbers that arguments or results have together.
std::size_t count_numbers(const std::vector<Argument>& list);

/// A robot in a scene whose functions are computed by the interpreter in double: no code is emitted
/// or compiled. They have the arguments and results of generated functions of `sin_cos: computed`,
/// and rows of a task yield near singularities as in those.
class InterpretedRobot {
 public:
  /// `robot` and `scene` must outlive this object.
  InterpretedRobot(const Robot& robot, const Scene& scene);

  [[nodiscard]] const Mechanism& mechanism() { return mechanisms_.whole(); }
  /// Functions that the scene asks for, `damped_control_torque` last.
  [[nodiscard]] const std::vector<Function>& functions() const { return functions_; }
  /// Arguments and results of a function of the scene. The first call traces the function.
  const InterpretedFunction& describe(Function function);
  /// Results of the function at a number of states. `arguments` has for each state the numbers of
  /// all arguments in their order; the results are laid out alike.
  [[nodiscard]] std::vector<double> call(const InterpretedFunction& function, std::size_t states,
                                         const std::vector<double>& arguments) const;

 private:
  GeneratedFunction trace(Function function);

  RouteOptions options_;
  FunctionMechanisms mechanisms_;
  Subject<double> subject_;
  std::vector<Function> functions_;
  std::map<Function, InterpretedFunction> described_;
};

}  // namespace treeline
