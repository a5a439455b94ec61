#pragma once

#include <span>
#include <string>

#include "emission/adapt.hpp"
#include "emission/contents.hpp"
#include "emission/keep_named.hpp"

namespace treeline {

/// Whether a function takes sines and cosines of joints' angles.
bool takes_sines(const Program& program);

/// How code outside of the loops over links names what is in them.
Adaptation name_loops(const EmissionContext& context);

/// The headers `runtime/emitted/link_*.h` as one, of which each function of a folder names some.
std::string adapt_loops(const Contents& contents, std::span<const NameSet> named);

}  // namespace treeline
