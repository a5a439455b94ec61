#pragma once

#include <vector>

#include "check/draw_state.hpp"
#include "check/subject.hpp"
#include "description/scene.hpp"
#include "interpreter/digits50.hpp"

namespace treeline {

/// What the interpreter says that a function's results are, in the order and layout of the
/// generated function's outputs, one after the other. For float, double and Digits50.
template <class Scalar>
std::vector<Scalar> interpret(Function function, const Subject<Scalar>& subject,
                              const State& state);

extern template std::vector<float> interpret(Function, const Subject<float>&, const State&);
extern template std::vector<double> interpret(Function, const Subject<double>&, const State&);
extern template std::vector<interpreter::Digits50> interpret(Function,
                                                             const Subject<interpreter::Digits50>&,
                                                             const State&);

}  // namespace treeline
