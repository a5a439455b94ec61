#pragma once

#include <string>

#include "emission/emission_context.hpp"
#include "program/program.hpp"

namespace treeline {

/// `void NAME(const Real (&q)[6], Real (&tau)[6]) noexcept;`, as the header declares it.
std::string print_declaration(const Program& program);

/// The source file that defines the program's function.
std::string print_source(const EmissionContext& context, const Program& program);

/// True when some result needs a sine or cosine.
bool uses_lanes(const Program& program);

/// Whether the emitted function needs sine and cosine.
bool uses_trigonometry(const Program& program);

/// "320 flops (170 additions, 150 multiplications, 0 divisions), sine and cosine of 6 angles".
std::string describe_cost(const Program& program);

/// How many values are alive at once, at most, when the nodes are computed in their order; times
/// sizeof(Real) that bounds what the function keeps on the stack beside the sines and cosines.
int count_live_values(const Program& program);

}  // namespace treeline
