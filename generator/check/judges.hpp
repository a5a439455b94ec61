#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <vector>

#include "bounds/domain.hpp"
#include "check/check.hpp"
#include "check/report.hpp"
#include "compilation/generated_library.hpp"
#include "description/robot.hpp"
#include "description/scene.hpp"
#include "generation/generate_code.hpp"
#include "oracle/reference.hpp"

namespace treeline {

/// Reports of each function of the generation how far its equation is from holding at the first of
/// these states, which are of every class: the results in 50 digits, with which the code is
/// compared, against derivatives of lower functions along motions. `report` has the functions.
void judge_equations(const Robot& robot, const Scene& scene, const Generation& generation,
                     const std::vector<StateReference>& references, int threads,
                     CheckReport& report);

/// Calls function `i` of the libraries at all states and compares its results with the references.
/// Errors of `accurate` are compared with the bound. Bits of `exact`, which was compiled without
/// contraction of products and sums, are compared with those of the graph. (Both are the same
/// library if no flag asks for contraction.) In states within `domain` no error may exceed
/// `generated.rounding`.
FunctionReport judge_function(std::size_t i, const GeneratedFunction& generated,
                              const std::vector<StateReference>& references, Real real,
                              const Domain& domain, const GeneratedLibrary& accurate,
                              const GeneratedLibrary& exact);

/// Whether the numbers are equal including their signs, or both are NaN.
bool same_bits(double a, double b);

/// Whether results are those of the function's graph to the bit. Of loops over links, and of a
/// solve for columns, zeros may have another sign, since they add zeros that the graph leaves out,
/// and where the function is singular there may be NaN in place of numbers.
bool are_bits_of_graph(const GeneratedFunction& generated, const std::vector<double>& results,
                       const FunctionReference& reference);

/// Value below which the given share of the values lies. Changes the order of the values.
double quantile(std::vector<double>& values, double share);

/// Sources compiled beside the functions of a scene with limits: none for other scenes.
std::vector<WorkSource> limited_sources(const Scene& scene, const Generation& generation);

/// Calls limited_control_torque, of one state or of a batch, at the states, each without a start
/// from the one before. At most `kMostCertified` of those that are limited, spread evenly over
/// them, are certified.
LimitsReport judge_limits(const Robot& robot, const Scene& scene, const Generation& generation,
                          const std::vector<StateReference>& references,
                          const GeneratedLibrary& library, bool batch, int threads);
inline constexpr int kMostCertified = 100;

/// Inputs and outputs of one call of a function at a state.
struct Call {
  const State* state = nullptr;
  double condition = 1;  ///< condition number of the matrix that it solves with
  /// Size of each entry's terms. An error below their rounding says nothing about the code, because
  /// a first-order bound vanishes together with its value.
  std::span<const double> sizes;
  CallResult result;
};

/// Compares results with the stated rounding errors of `generated`. Errors are differences from the
/// graph in long double, whose own errors are negligible. A proven bound is compared in states of
/// `domain`. A first-order bound is propagated to every state and compared there, except where
/// second-order errors could matter. Returns nothing if no bound is known. `unit` is half an ulp of
/// one.
std::optional<RoundingReport> judge_rounding(const GeneratedFunction& generated,
                                             const Domain& domain, double unit,
                                             const std::vector<Call>& calls);

/// Compile options with the sources of the controller, if there is one: to compile with a folder.
CompileOptions with_controller(const Scene& scene, const Generation& generation,
                               CompileOptions options);

/// Runs the controller's step that was compiled into `compilation`, over motions with commands and
/// switches of modes, and compares steps with the same laws in long double, whose dynamics the
/// interpreter computes in 50 digits. What no step may do is looked for in all of them. Returns
/// nothing if the reference cannot be compiled; `diagnostics` says why.
std::optional<StepReport> judge_step(const Robot& robot, const Scene& scene,
                                     const Generation& generation, const CheckOptions& options,
                                     const Compilation& compilation,
                                     const std::filesystem::path& work, Diagnostics& diagnostics);

}  // namespace treeline
