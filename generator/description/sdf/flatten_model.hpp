#pragma once

#include <optional>
#include <sdf/Model.hh>
#include <string>

#include "description/flat/flat_model.hpp"
#include "text/diagnostic.hpp"

namespace treeline {

/// Links, frames and joints of a model and of those nested in it, whose names have `MODEL::` before
/// them. `file` is for the diagnostics. Nothing, and an error, where a pose or an axis cannot be
/// resolved or a joint is of a kind that has no place here.
std::optional<FlatModel> flatten_model(const sdf::Model& model, const std::string& file,
                                       Diagnostics& diagnostics);

}  // namespace treeline
