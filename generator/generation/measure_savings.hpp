#pragma once

#include <string>
#include <vector>

#include "description/robot.hpp"
#include "description/scene.hpp"

namespace treeline {

/// A function that a scene could have: the size of its code, and whether the scene has it.
struct FunctionSize {
  Function function{};
  bool emitted = false;
  int flops = 0;
  std::size_t bytes = 0;  ///< size of its source file
};

/// The code emitted for a scene, compared with every function that its robot, points, objects and
/// contacts permit.
struct Savings {
  std::string scene;
  std::vector<FunctionSize> functions;

  struct Sum {
    int functions = 0, flops = 0;
    std::size_t bytes = 0;
  };
  [[nodiscard]] Sum emitted() const;
  [[nodiscard]] Sum possible() const;
};

/// Lists the functions that the scene could ask for, sorted.
std::vector<Function> possible_functions(const Robot& robot, const Scene& scene);

/// Generates each of these functions. Functions that cannot be generated, for lack of mass or of
/// freedoms, are left out.
Savings measure_savings(const Robot& robot, const Scene& scene);

/// Prints a line for each function.
std::string print_functions(const Savings& savings);
/// Prints `scene  functions  flops  bytes`, emitted of possible, in a line for each scene.
std::string print_table(const std::vector<Savings>& scenes);

}  // namespace treeline
