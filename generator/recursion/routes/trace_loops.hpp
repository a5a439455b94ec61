#pragma once

#include <optional>

#include "functions/function.hpp"
#include "mechanism/mechanism.hpp"
#include "program/program.hpp"

namespace treeline {

/// Key of the route by loops over a table of links, which `--choices` may name.
inline constexpr const char* kLoopsKey = "loops";

/// Whether the function may have such a form; of some robots it has none.
bool has_loop_form(Function function);

/// The function as a loop over a table of links, for small code; nothing where it has no such form.
/// The graph is the trace of `runtime/emitted/link_functions.h`: it has the operations that the
/// loops execute, in their order, but for products and sums with the constants 0 and 1, which are
/// exact (a zero may have another sign). So what is evaluated, bounded and proven of the graph
/// holds for the loops, as long as no pass changes it. `lines` is the function as straight lines.
/// With `given_sines` it reads sin_q[i] and cos_q[i] of angles; its
/// arguments do not list them.
std::optional<Program> trace_loops(const Mechanism& mechanism, Function function,
                                   const Program& lines, bool given_sines);

}  // namespace treeline
