#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <vector>

#include "functions/quantity.hpp"
#include "mechanism/mechanism.hpp"
#include "oracle/subject.hpp"

namespace treeline {

/// What a state is there to provoke.
enum class StateClass {
  neutral,  ///< q = 0, at rest or moving
  random,   ///< anywhere within the limits, at ordinary speeds
  large,    ///< angles of many turns, far beyond the limits
  fast,     ///< velocities and accelerations far beyond the ordinary
  tiny,     ///< coordinates and velocities from 1e-12 to 1e-2
  aligned,  ///< joints at or next to multiples of a quarter turn, where arms become singular
  limits,   ///< most joints at one of their limits, where they have any
};
inline constexpr std::array kStateClasses = {
    StateClass::neutral, StateClass::random,  StateClass::large, StateClass::fast,
    StateClass::tiny,    StateClass::aligned, StateClass::limits};
const char* state_class_name(StateClass kind);

/// Inputs of all functions. `qdd` is also the posture's qdd_0. Every number is exact in the
/// generated code's Real; quaternions have unit length but for that rounding or, every other
/// state, for rounding to float.
struct State {
  int index = 0;
  StateClass kind = StateClass::random;
  std::vector<double> q, qd, qdd, tau, xdd_cmd, f_ext;
  std::vector<double> sin_q, cos_q;                ///< of q, rounded
  std::map<Quantity, std::vector<double>> others;  ///< all further quantities
};

/// What the state has for a quantity; empty where it has nothing.
const std::vector<double>& values_of(const State& state, Quantity quantity);

/// Where states are drawn from.
struct StateSpace {
  Subject<double> subject;
  std::vector<Coordinate> coordinates;  ///< nq of them, with limits
  std::uint64_t seed = 1;
  bool single_precision = false;
  std::map<Quantity, int> others = {};  ///< sizes of the quantities that have no member in `State`
};

/// Any so many states that follow each other are some of every class.
inline constexpr int kStatesOfEveryClass = 20;

/// The class of each state is a matter of its index alone, so that any number of states is a mix.
StateClass class_of_state(int index);

/// State `index` of the space: a matter of seed, index and robot, not of other states drawn.
State draw_state(const StateSpace& space, int index);

}  // namespace treeline
