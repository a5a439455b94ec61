#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <vector>

#include "functions/quantity.hpp"
#include "mechanism/mechanism.hpp"
#include "oracle/subject.hpp"

namespace treeline {

/// Class of a state, by the difficulty that it shall provoke.
enum class StateClass {
  neutral,  ///< q = 0, at rest or moving
  random,   ///< anywhere within the limits, at ordinary velocities
  large,    ///< angles of many turns, far beyond the limits
  fast,     ///< velocities and accelerations far beyond ordinary ones
  tiny,     ///< coordinates and velocities from 1e-12 to 1e-2
  aligned,  ///< joints at or near multiples of a quarter turn, where arms become singular
  limits,   ///< most joints at one of their limits, if they have any
};
inline constexpr std::array kStateClasses = {
    StateClass::neutral, StateClass::random,  StateClass::large, StateClass::fast,
    StateClass::tiny,    StateClass::aligned, StateClass::limits};
const char* state_class_name(StateClass kind);

/// Inputs of all functions in SI units. `qdd` is also the posture's qdd_0. Every number is exact in
/// the Real of the generated code. Quaternions have unit length up to that rounding or, in every
/// other state, up to rounding to float.
struct State {
  int index = 0;
  StateClass kind = StateClass::random;
  std::vector<double> q, qd, qdd, tau, xdd_cmd, f_ext;
  std::vector<double> sin_q, cos_q;                ///< of q, rounded
  std::map<Quantity, std::vector<double>> others;  ///< all further quantities
};

/// Values of a quantity in the state; empty where the state has none.
const std::vector<double>& values_of(const State& state, Quantity quantity);

/// Place for the values of a quantity in the state; empty where the state had none.
std::vector<double>& place_of(State& state, Quantity quantity);

/// The space from which states are drawn.
struct StateSpace {
  Subject<double> subject;
  std::vector<Coordinate> coordinates;  ///< nq entries, with limits
  std::uint64_t seed = 1;
  bool single_precision = false;
  std::map<Quantity, int> others = {};  ///< sizes of the quantities that have no member in `State`
};

/// Largest angle, rad, of which the emitted code has sine and cosine to the last digits: see
/// core/sin_cos.hpp. A limit beyond it says no more than that there is none; exporters write 1e16.
constexpr double farthest_angle(bool single_precision) {
  return single_precision ? 4000 : 2e8;
}

/// Any sequence of this many consecutive states contains all classes.
inline constexpr int kStatesOfEveryClass = 20;

/// Class of state `index`. It depends only on the index, so any number of states is a mix of
/// classes.
StateClass class_of_state(int index);

/// Draws state `index` of the space. It depends on seed, index and robot only, not on other states.
State draw_state(const StateSpace& space, int index);

}  // namespace treeline
