#pragma once

#include "description/diagnostic.hpp"
#include "description/scene.hpp"
#include "generation/generate_code.hpp"
#include "mechanism/mechanism.hpp"

namespace treeline {

/// Makes a function that was generated as straight lines one that loops over a table of links, if
/// it has this form and its code is estimated to be smaller so; with `always` whether it is or not.
/// Its program is as traced, see `trace_loops`. A note says what kept a function with this form
/// from it; with `always` an error.
void choose_loops(const Mechanism& mechanism, const Scene& scene, bool always,
                  GeneratedFunction& generated, Diagnostics& diagnostics);

}  // namespace treeline
