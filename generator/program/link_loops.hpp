#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "program/emitted_links.hpp"

namespace treeline {

/// The types of a table of links, in the numbers of the generator.
using LinkTypes = EmittedLinks<double>;

/// An argument that says something of links or points of the table.
struct LinkInput {
  enum class Gives { bodies, origins, axes, rotors, dampings, frictions };
  std::string argument;
  Gives gives = Gives::bodies;
  std::vector<LinkTypes::TlInputFrame> frames;
  /// Index of each given number among the ten of its body, where bodies are given in part.
  std::vector<std::int16_t> entries = {};
  std::vector<LinkTypes::TlInputNumber> numbers = {};  ///< of joints, in place of frames

  [[nodiscard]] bool is_of_points() const {
    return gives == Gives::origins || gives == Gives::axes;
  }
};

/// The robot as a table of its links, for functions that loop over it: see
/// `runtime/emitted/link_types.h`.
struct LinkTableData {
  bool floats = false;     ///< the first link is a floating base
  bool sliding = false;    ///< there are prismatic joints
  bool own_sines = false;  ///< joints turn by multiples of coordinates of others
  bool freed = false;      ///< joints beyond the base move freely
  bool grounded = false;   ///< points, or external forces, are on the world
  bool turning = false;    ///< linear rows of points are along axes that turn with their links
  int slots = 1;
  std::array<double, 3> gravity{};
  std::vector<LinkTypes::TlLink> links;
  std::vector<std::string> names;  ///< of the links
  std::vector<LinkTypes::TlLinkPoint> points;
  std::vector<LinkTypes::TlPointRow> rows;
  std::vector<std::int16_t>
      row_entries;  ///< of all rows in arguments and results; none: their order
  // Of all links, or none.
  std::vector<LinkTypes::TlLinkDrive> drives;
  std::vector<LinkTypes::TlLinkFriction> frictions;
  std::vector<LinkTypes::TlLinkCoupling> couplings;
  int joints = 0;  ///< that have coordinates of their own, where there are couplings
  std::vector<LinkTypes::TlLinkBall> balls;           ///< of all links, or none
  int rotations = 1;                                  ///< of a floating base and of ball joints
  std::vector<LinkTypes::TlLinkPoint> pushed_points;  ///< of external forces
  std::vector<LinkInput> inputs;                      ///< which the functions take
  std::vector<std::int16_t> loaded_links;             ///< whose inertia depends on them

  /// Whether an argument gives this.
  [[nodiscard]] bool gives(LinkInput::Gives what) const {
    return std::any_of(inputs.begin(), inputs.end(),
                       [&](const LinkInput& input) { return input.gives == what; });
  }
};

/// Power of the law of `core/prioritized_solve.hpp`.
inline constexpr int kPowerOfPriorities = 8;

/// How a function is emitted that loops over a table of links: a call of `function` in
/// `runtime/emitted/link_functions.h`, of which the program's graph is the trace.
struct LinkLoops {
  std::string function;
  LinkTableData table;
  /// Work space beside motions: `TlFactorWork`, `TlMatrixWork`, `TlRowWork`.
  bool uses_factors = false, uses_matrix = false, uses_rows = false;
  bool solves = false;         ///< takes the law by which rows yield
  bool uses_friction = false;  ///< depends on that of joints
  std::string f_ext;           ///< the argument of external forces; empty: none
  std::string gravity;         ///< the argument; empty: as the table says
  std::string step;            ///< at whose end drives are taken; empty: none
  int power = 0;               ///< of this law; 0: none
  /// Border of each row to that power; for the law of priorities, the least mobility of each row.
  std::vector<double> yields;
  int adds = 0, muls = 0, divs = 0, sines = 0;  ///< executed, those with constants 0 and 1 too
};

}  // namespace treeline
