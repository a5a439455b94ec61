#pragma once

#include <string>
#include <vector>

#include "description/robot.hpp"
#include "description/scene.hpp"

namespace treeline {

/// A function that a scene could have: what its code takes, and whether the scene has it.
struct FunctionSize {
  Function function{};
  bool emitted = false;
  int flops = 0;
  std::size_t bytes = 0;  ///< of its source file
};

/// What is emitted for a scene beside what there could be: every function that its robot, points,
/// objects and contacts permit.
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

/// The functions that the scene could have asked for, sorted.
std::vector<Function> possible_functions(const Scene& scene);

/// Generates each of them. A function that cannot be generated, for want of mass or of freedoms, is
/// left out.
Savings measure_savings(const Robot& robot, const Scene& scene);

/// A line for each function.
std::string print_functions(const Savings& savings);
/// `scene  functions  flops  bytes`, emitted of possible, a line for each scene.
std::string print_table(const std::vector<Savings>& scenes);

}  // namespace treeline
