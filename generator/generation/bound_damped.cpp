#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>

#include "bounds/draw_inputs.hpp"
#include "choice/evaluate_damped.hpp"
#include "description/scene_queries.hpp"
#include "generation/compose.hpp"
#include "program/evaluate.hpp"
#include "text/round_outward.hpp"

namespace treeline {
namespace {

constexpr int kBatches = 16;  // of kStatesAtOnce states

/// All arguments of the functions as inputs of one graph, entry by entry.
struct Arguments {
  Graph graph;
  std::vector<std::pair<std::string, std::size_t>> sizes;
};

Arguments arguments_of(const std::vector<const Program*>& programs) {
  Arguments all;
  for (const Program* program : programs) {
    for (const Argument& argument : program->arguments) {
      const auto size = static_cast<std::size_t>(argument.rows * argument.cols);
      const std::pair entry{argument.name, size};
      if (std::find(all.sizes.begin(), all.sizes.end(), entry) != all.sizes.end()) continue;
      all.sizes.push_back(entry);
    }
  }
  for (const auto& [name, size] : all.sizes) {
    for (std::size_t i = 0; i < size; ++i) all.graph.input(fmt::format("{}[{}]", name, i));
  }
  return all;
}

/// Values of the arguments at one state, by name; each is a number of the emitted code's Real.
using Values = std::map<std::string, std::vector<double>>;

template <class T>
std::vector<T> result_of(const Program& program, const Values& values) {
  std::vector<std::vector<T>> arguments;
  for (const Argument& argument : program.arguments) {
    const std::vector<double>& own = values.at(argument.name);
    arguments.emplace_back(own.begin(), own.end());
  }
  return evaluate<T>(program, arguments).front();
}

/// The functions in the order of `DampedInputs`.
std::vector<const Program*> called(const std::vector<GeneratedFunction>& functions) {
  std::vector<const Program*> programs;
  for (const Function function : {Function::lambda_inverse, Function::jacobian,
                                  Function::bias_acceleration, Function::inverse_dynamics}) {
    const auto found = std::find_if(functions.begin(), functions.end(),
                                    [&](const auto& each) { return each.function == function; });
    programs.push_back(&found->program);
  }
  return programs;
}

template <class T>
std::vector<T> damped(const std::vector<const Program*>& programs, const Values& values,
                      const std::vector<double>& mass_limits) {
  const auto to = [](const std::vector<double>& from) {
    return std::vector<T>(from.begin(), from.end());
  };
  return evaluate_damped_in<T>(
      {result_of<T>(*programs[0], values), result_of<T>(*programs[1], values),
       result_of<T>(*programs[2], values), result_of<T>(*programs[3], values), to(values.at("qdd")),
       to(values.at("xdd_cmd")), to(mass_limits)});
}

/// The largest error of a torque, and of the least eigenvalue.
struct Errors {
  double tau = 0, least_eigenvalue = 0;
};

template <class T>
Errors errors_at(const std::vector<const Program*>& programs, const Values& values,
                 const std::vector<double>& mass_limits) {
  const auto computed = damped<T>(programs, values, mass_limits);
  const auto exact = damped<long double>(programs, values, mass_limits);
  Errors errors;
  for (std::size_t i = 0; i < computed.size(); ++i) {
    double& own = i + 1 == computed.size() ? errors.least_eigenvalue : errors.tau;
    own = std::max(own, static_cast<double>(std::abs(exact[i] - computed[i])));
  }
  return errors;
}

/// Text with the quantiles of 50 %, 90 % and 99 % of the errors, one digit each, rounded up.
std::string quantiles(std::vector<double> errors) {
  std::sort(errors.begin(), errors.end());
  std::string text;
  for (const double share : {0.50, 0.90, 0.99}) {
    const double at = std::ceil(share * static_cast<double>(errors.size())) - 1;
    const double error = errors[static_cast<std::size_t>(at)];
    text += (text.empty() ? "" : ", ") + rounded_up(error, 1);
  }
  return text;
}

}  // namespace

std::string describe_damped_rounding(const std::vector<GeneratedFunction>& functions,
                                     const Scene& scene, const Domain& domain) {
  const auto programs = called(functions);
  Arguments arguments = arguments_of(programs);
  const std::vector<double> mass_limits = effective_mass_limits(scene);
  arguments.sizes.emplace_back("xdd_cmd", mass_limits.size());
  for (std::size_t i = 0; i < mass_limits.size(); ++i) {
    arguments.graph.input(fmt::format("xdd_cmd[{}]", i));
  }
  const bounds::InputSpace space(arguments.graph, domain);
  if (space.missing()) return "no bound is known: no range is stated for " + *space.missing();
  Rng rng(1);
  std::vector<bounds::States> inputs(arguments.graph.inputs().size());
  std::vector<double> tau, least_eigenvalue;
  for (int state = 0; state < kBatches * static_cast<int>(bounds::kStatesAtOnce); ++state) {
    space.put(space.draw(rng), 0, inputs);
    Values values;
    std::size_t next = 0;
    for (const auto& [name, size] : arguments.sizes) {
      for (std::size_t i = 0; i < size; ++i) {
        const double drawn = inputs[next++][0];
        values[name].push_back(
            scene.real == Real::float32 ? static_cast<double>(static_cast<float>(drawn)) : drawn);
      }
    }
    const Errors errors = scene.real == Real::float32
                              ? errors_at<float>(programs, values, mass_limits)
                              : errors_at<double>(programs, values, mass_limits);
    tau.push_back(errors.tau);
    least_eigenvalue.push_back(errors.least_eigenvalue);
  }
  return fmt::format("in 50, 90, 99 of 100 states, as measured, at most {} in tau; {} in the ease",
                     quantiles(std::move(tau)), quantiles(std::move(least_eigenvalue)));
}

}  // namespace treeline
