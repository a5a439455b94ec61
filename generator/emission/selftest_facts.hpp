#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace treeline {

/// Numbers of NAME_selftest: where functions are called and what they give there, exact in Real.
struct SelftestFacts {
  /// An array by state.
  struct Values {
    std::string name;
    std::vector<std::vector<double>> by_state;
  };
  /// A function that is called, in the order of its numbers from 1 on.
  struct Called {
    std::string function;
    std::vector<Values> results;
  };
  /// A motion of the controller's step: `ticks` steps for each command.
  struct Motion {
    static constexpr int kTicks = 8;
    static constexpr double kDuration = 0.5;  ///< of commands, s
    static constexpr double kForce = 5;       ///< N, of the command that presses

    std::vector<std::string> kinds;    ///< of the commands, as enumerators without the name
    std::vector<double> q, way, goal;  ///< of joints: at first, on in each step, from q to goals
    double rate = 0;                   ///< steps in a second, by which ways are velocities
    std::vector<Values> inputs;        ///< further members of the input, which stay
    std::vector<std::vector<double>> tau;  ///< after the last step of each command
    std::vector<int> modes;
    std::vector<std::uint32_t> faults;
  };

  int states = 0;
  std::vector<Values> arguments;  ///< of the functions, each once
  std::vector<Called> functions;
  std::vector<std::string> left_out;  ///< functions that are not called
  std::optional<Motion> motion;       ///< of the controller, if there is one
};

}  // namespace treeline
