#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "bench/peers/describe_to_peers.hpp"
#include "interpreter/model.hpp"
#include "subject.hpp"

namespace treeline::bench {

/// Inputs of one call of every function.
struct State {
  std::vector<double> q, qd, qdd, tau, xdd;
};

/// A robot in the form that every subject uses.
struct Case {
  std::string robot;
  std::string urdf;  ///< path, without shapes and mimic tags
  PeerDescription description;
  interpreter::Model<double> model;
  interpreter::Points<double> points;

  [[nodiscard]] int rows() const;
};

/// Reads a robot of `robot_names()`. Returns nothing, after messages on stderr, if that fails.
std::optional<Case> read_case(const std::string& robot);

/// Names of the robots with which this build was configured.
const std::vector<std::string>& robot_names();

/// Draws states uniformly: positions within 3, velocities 2, accelerations 5, torques 20; unit
/// quaternions.
std::vector<State> random_states(const Case& robot, int count, std::uint64_t seed);

/// Inputs of a function in the order of the contract.
std::vector<const std::vector<double>*> inputs_of(Function function, const State& state);

/// Number of entries that a function returns.
int output_size(Function function, const Case& robot);

std::string name_of(Function function);

inline constexpr Function kFunctions[] = {Function::inverse_dynamics,
                                          Function::forward_dynamics,
                                          Function::mass_matrix,
                                          Function::mass_matrix_inverse,
                                          Function::lambda_inverse,
                                          Function::lambda,
                                          Function::control_torque,
                                          Function::inverse_dynamics_derivatives,
                                          Function::forward_dynamics_derivatives};

}  // namespace treeline::bench
