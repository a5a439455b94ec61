#include <algorithm>

#include "choice/choose_loops.hpp"
#include "description/follow_target.hpp"
#include "target/target.hpp"

namespace treeline {
namespace {

/// Numbers of a row of the table of links.
constexpr double kNumbersOfLink = 21;
constexpr double kNumbersOfFrame = 12;
constexpr double kNumbersOfDrive = 3;
constexpr double kNumbersOfFriction = 2;
constexpr double kNumbersOfCoupling = 2;

/// Bytes of the loops in float on a Cortex-M4F by g++ 12, whatever the robot is, see `CodeSizes`.
constexpr double kBytesOfPoses = 690;
constexpr double kBytesOfMotions = 1280;
constexpr double kBytesOfInertias = 1700;
constexpr double kBytesOfRows = 1370;
constexpr double kBytesOfAccelerations = 980;
constexpr double kBytesOfControl = 980;
constexpr double kBytesOfInput = 250;  ///< of each argument that changes the table

const CodeSizes& sizes_of(const Scene& scene) {
  return code_sizes(*find_target(scene.target), bytes_of(scene.real));
}

double count_numbers(const LinkTableData& table) {
  double numbers = static_cast<double>(table.links.size()) * kNumbersOfLink +
                   static_cast<double>(table.drives.size()) * kNumbersOfDrive +
                   static_cast<double>(table.frictions.size()) * kNumbersOfFriction +
                   static_cast<double>(table.couplings.size()) * kNumbersOfCoupling;
  for (const LinkInput& input : table.inputs) {
    numbers += static_cast<double>(input.frames.size()) * kNumbersOfFrame;
  }
  return numbers;
}

}  // namespace

double bytes_of_lines(const Scene& scene, int flops) {
  const CodeSizes& sizes = sizes_of(scene);
  return flops * sizes.operation + sizes.start;
}

void LoopNeeds::add(Function function, const LinkLoops& loops) {
  const bool forward = function == Function::forward_dynamics;
  const bool control = function == Function::control_torque;
  const bool has_inertias = loops.uses_factors && loops.table.couplings.empty();
  moves_ = moves_ || !has_inertias || forward || control;
  has_inertias_ = has_inertias_ || has_inertias;
  has_rows_ = has_rows_ || loops.uses_rows;
  accelerates_ = accelerates_ || forward;
  controls_ = controls_ || control;
  inputs_ = std::max(inputs_, static_cast<int>(loops.table.inputs.size()));
  numbers_ = std::max(numbers_, count_numbers(loops.table));
}

double LoopNeeds::bytes(const Scene& scene) const {
  const double code = kBytesOfPoses + (moves_ ? kBytesOfMotions : 0) +
                      (has_inertias_ ? kBytesOfInertias : 0) + (has_rows_ ? kBytesOfRows : 0) +
                      (accelerates_ ? kBytesOfAccelerations : 0) +
                      (controls_ ? kBytesOfControl : 0) + inputs_ * kBytesOfInput;
  return code * sizes_of(scene).loops + numbers_ * bytes_of(scene.real);
}

}  // namespace treeline
