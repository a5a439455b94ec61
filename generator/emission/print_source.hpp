#pragma once

#include <set>
#include <string>

#include "emission/emission_context.hpp"
#include "program/program.hpp"

namespace treeline {

/// `void NAME(const Real (&q)[6], Real (&tau)[6]) noexcept;`, as the header declares it.
std::string print_declaration(const Program& program);

/// The source file that defines the program's function.
std::string print_source(const EmissionContext& context, const Program& program);

/// Whether the function reads any element of this argument.
bool reads(const Program& program, const Argument& argument);

/// Names that no local may have: arguments, what the header and the file declare.
std::set<std::string> find_taken_names(const EmissionContext& context, const Program& program);

/// Whether the function has so many operations (12000) that some passes of compilers may take
/// minutes.
bool is_long(const Program& program);

/// What a source file asks of the compiler: GCC's passes that save spills; of long functions
/// nothing.
std::string print_optimize(const Program& program);

/// Whether some numbers of the emitted function share registers.
bool uses_lanes(const Program& program);

/// Whether the emitted function needs sine and cosine.
bool uses_trigonometry(const Program& program);

/// "320 flops (170 additions, 150 multiplications, 0 divisions), sine and cosine of 6 angles".
std::string describe_cost(const Program& program);

/// How many values are alive at once, at most, when the nodes are computed in their order; times
/// sizeof(Real) that bounds what the function keeps on the stack beside the sines and cosines.
int count_live_values(const Program& program);

}  // namespace treeline
