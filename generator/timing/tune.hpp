#pragma once

#include <functional>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "choice/choices.hpp"
#include "compilation/compile_folder.hpp"
#include "generation/generate_code.hpp"
#include "timing/load_build.hpp"
#include "timing/time_calls.hpp"

namespace treeline {

/// A candidate for computing a function, and its times.
struct Trial {
  RouteChoice choice;  ///< with lanes, except for a batch
  OperationCount count;
  Timing measured;  ///< relative to the first candidate's
};

/// Trials of one function, the route of least cost first, and the winner.
struct TunedFunction {
  Function function{};
  int batch = 0;  ///< see `GeneratedFunction`
  std::vector<Trial> trials;
  std::size_t fastest = 0;
};

struct Tuning {
  std::vector<TunedFunction> functions;  ///< in the scene's order, each before its batch
  std::string measured;                  ///< compiler, flags and processor
};

/// Times candidates of one function relative to the first one. Errors: those of the compiler.
using Measure = std::function<std::optional<std::vector<Timing>>(
    const std::vector<GeneratedFunction>& candidates, Diagnostics& diagnostics)>;

struct TuneOptions {
  /// Routes whose cost exceeds the least by more than this share are not tried.
  double reach = 0.12;
  /// The route of least cost stays unless another one is faster by this share, and by twice the
  /// noise.
  double margin = 0.02;
  /// Called before each function is measured, with its name and the number of candidates.
  std::function<void(const std::string& function, std::size_t candidates)> progress = {};
};

/// Lists the candidates for a function that may be fastest and have different code: each route in
/// 1, 2, 4 and 8 lanes, with and without isomorphic limbs in lanes. The first is the one that
/// `generate_code` makes without choices. Routes whose cost exceeds the least by more than the
/// share `reach` are left out.
std::vector<GeneratedFunction> list_candidates(const Mechanism& mechanism, Function function,
                                               const Scene& scene, bool batch, double reach);

/// Measures the candidates of each function of the scene and picks the one of least cost. Errors:
/// the scene has `optimize: size`, which no time decides.
std::optional<Tuning> tune(const Robot& robot, const Scene& scene, const Measure& measure,
                           const TuneOptions& options, Diagnostics& diagnostics);

/// Converts the result of `tune` to choices for generating code.
Choices choices_of(const Tuning& tuning);

/// Returns a measure that compiles candidates on this machine and times them in interleaved order
/// at 64 states: first all of them a few times, then many times those that may win. `robot` and
/// `scene` must outlive it.
Measure measure_here(const Robot& robot, const Scene& scene, const CompileOptions& compile);

/// Describes this machine for `measure_here`: "g++ (Debian 12.2.0-14) 12.2.0, -O3 -march=native,
/// AMD EPYC".
std::string describe_here(const CompileOptions& compile, Diagnostics& diagnostics);

/// All trials, fastest first, with times in nanoseconds per call: as a table, or as a JSON list.
std::string print_text(const Tuning& tuning);
nlohmann::ordered_json to_json(const Tuning& tuning);

}  // namespace treeline
