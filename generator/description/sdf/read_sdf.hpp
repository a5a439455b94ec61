#pragma once

#include <optional>
#include <string>

#include "description/flat/flat_model.hpp"
#include "text/diagnostic.hpp"

namespace treeline {

/// The one model of an SDF file, read by libsdformat. `text` is the file's content, `path` where it
/// is: models that it includes are looked for beside it and in the folders of SDF_PATH,
/// GZ_SIM_RESOURCE_PATH, IGN_GAZEBO_RESOURCE_PATH and GAZEBO_MODEL_PATH. Faults are in
/// `diagnostics`; what has a meaning for the motion and no place in `FlatModel` is a warning or an
/// error. libsdformat is loaded when it is needed, for it takes as long as a whole generation of a
/// small robot; where it was missing at build time there is only an error that names its package.
///
/// libsdformat composes poses by quaternions in double: they are those of the file but for 1e-15
/// rad, and 1e-15 of the model's size. What is that close to a quarter turn or to 0 is made so.
std::optional<FlatModel> read_sdf(const std::string& text, const std::string& path,
                                  Diagnostics& diagnostics);

/// Well-formed XML, the path of its file, and what messages call it.
struct SdfText {
  std::string text, path, shown;
};

/// Type of the function that the module `treeline_sdf.so` exports as `kSdfReader`: see `read_sdf`.
using SdfReader = void(const SdfText& text, std::optional<FlatModel>& model,
                       Diagnostics& diagnostics);
inline constexpr const char* kSdfReader = "treeline_read_sdf";

}  // namespace treeline
