#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "check/compile_folder.hpp"
#include "generation/choices.hpp"
#include "generation/generate_code.hpp"
#include "timing/load_build.hpp"
#include "timing/time_calls.hpp"

namespace treeline {

/// One way to compute a function, and how long it takes.
struct Trial {
  RouteChoice choice;  ///< with lanes, except of a batch
  OperationCount count;
  Timing timing;  ///< ratios are to the route of least cost
};

/// One function: what was tried, the route of least cost first, and what won.
struct TunedFunction {
  Function function{};
  int batch = 0;  ///< see `GeneratedFunction`
  std::vector<Trial> trials;
  std::size_t fastest = 0;
};

struct Tuning {
  std::vector<TunedFunction> functions;  ///< in the scene's order, each followed by its batch
  std::string measured;                  ///< compiler, flags and processor
};

/// Times candidates of one function against the first of them. Errors: those of the compiler.
using Measure = std::function<std::optional<std::vector<Timing>>(
    const std::vector<GeneratedFunction>& candidates, Diagnostics& diagnostics)>;

struct TuneOptions {
  /// Routes that cost more than the cheapest by this share are not tried.
  double reach = 0.12;
  /// The route of least cost stays unless another is faster by this share, and by twice the noise.
  double margin = 0.02;
  /// Called before each function is measured, with its name and how many candidates it has.
  std::function<void(const std::string& function, std::size_t candidates)> progress = {};
};

/// Every way to compute a function that may be the fastest and is not the same code as another:
/// each route in 1, 2, 4 and 8 lanes, alike limbs in lanes or not. First comes what `generate_code`
/// makes without choices.
std::vector<GeneratedFunction> list_candidates(const Mechanism& mechanism, Function function,
                                               const Scene& scene, bool batch, double reach);

/// Measures the candidates of each function of the scene and picks the fastest.
std::optional<Tuning> tune(const Robot& robot, const Scene& scene, const Measure& measure,
                           const TuneOptions& options, Diagnostics& diagnostics);

/// What `tune` found, to generate by.
Choices choices_of(const Tuning& tuning);

/// Compiles candidates on this machine and times them interleaved at 64 states: all of them a few
/// times, then those that may win many times. `robot` and `scene` must outlive it.
Measure measure_here(const Robot& robot, const Scene& scene, const CompileOptions& compile);

/// "g++ (Debian 12.2.0-14) 12.2.0, -O3 -march=native, AMD EPYC": what `measure_here` measures with.
std::string describe_here(const CompileOptions& compile, Diagnostics& diagnostics);

/// A table of all trials, fastest first, times in nanoseconds a call; as JSON a list.
std::string print_text(const Tuning& tuning);
std::string print_json(const Tuning& tuning);

}  // namespace treeline
