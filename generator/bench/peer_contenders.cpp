#include "bench/peer_contenders.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <utility>

namespace treeline {
namespace {

constexpr std::size_t kMostInputs = 6;
using PeerInputs = std::array<const double*, kMostInputs>;

/// Pointers to the inputs in the order of the generated contract, without external forces. Those
/// that the function does not have are null.
PeerInputs inputs_of(Function function, const State& state) {
  PeerInputs inputs{};
  std::size_t filled = 0;
  for (const Quantity quantity : info_of(function).inputs) {
    if (quantity == Quantity::f_ext || is_of_model(quantity)) continue;
    inputs.at(filled++) = values_of(state, quantity).data();
  }
  return inputs;
}

/// Says which requests of the scene for this function no peer can fulfil; empty if there are none.
std::string beyond_peers(const Scene& scene, const GeneratedFunction& function) {
  if (takes_external_forces(function.function) && !scene.external_forces.empty()) {
    return "external forces";
  }
  if (!scene.inputs.empty()) return "inputs";
  if (function.function == Function::constrained_forward_dynamics) {
    if (!scene.couplings.empty()) return "couplings";
    const bool rolls = std::any_of(scene.loops.begin(), scene.loops.end(),
                                   [](const SceneLoop& loop) { return loop.rolling.has_value(); });
    if (rolls) return "what rolls";
  }
  if (function.function == Function::inverse_dynamics_regressor &&
      scene.regressor != SceneRegressor{}) {
    return "columns other than the parameters of all links";
  }
  if (function.function == Function::control_torque && has_priorities(scene.operational_points)) {
    return "priorities";
  }
  return {};
}

std::size_t size_of(const GeneratedFunction& function) {
  std::size_t size = 0;
  for (const Result& result : function.program.results) size += result.values.size();
  return size;
}

/// A routine with its arguments for timing.
struct Prepared {
  PeerRoutine routine;
  Function function{};
  std::vector<State> states;
  std::vector<double> output;

  void pass() {
    for (const State& state : states) {
      const PeerInputs inputs = inputs_of(function, state);
      routine.call(routine.solver.get(), inputs.data(), output.data());
    }
  }
  [[nodiscard]] std::vector<double> call(const State& state) const {
    // A routine need not write entries that are zero for every robot.
    std::vector<double> entries(output.size(), 0);
    const PeerInputs inputs = inputs_of(function, state);
    routine.call(routine.solver.get(), inputs.data(), entries.data());
    if (routine.finish != nullptr) routine.finish(routine.solver.get(), entries.data());
    return entries;
  }
};

Contender contender_of(const LoadedPeer& peer, const PeerRoutine& routine,
                       const GeneratedFunction& function, const std::vector<State>& timed) {
  const auto prepared = std::make_shared<Prepared>(
      Prepared{routine, function.function, timed, std::vector<double>(size_of(function))});
  Variant variant{function.function, VariantGroup::peer, peer.name, Real::float64};
  if (!routine.route.empty()) variant.name += ", " + routine.route;
  variant.method = routine.route;
  variant.recorded = peer.functions->records;
  Contender contender{std::move(variant), {}, {}};
  contender.call = [prepared](const State& state) { return prepared->call(state); };
  contender.passes = {{[prepared] { prepared->pass(); }, timed.size()}};
  return contender;
}

}  // namespace

PeerContenders peer_contenders(const LoadedPeer& peer, const PeerDescription& description,
                               const std::filesystem::path& urdf, const Scene& scene,
                               const std::vector<GeneratedFunction>& functions,
                               const std::vector<State>& timed) {
  std::vector<std::string> names;
  for (const GeneratedFunction& function : functions) {
    if (beyond_peers(scene, function).empty()) names.emplace_back(function_name(function.function));
  }
  const OpenedPeer opened = open_peer(peer, urdf, description, names);
  PeerContenders made{{peer.name, peer.release, opened.sentences}, {}};
  std::vector<std::string> lacking;
  for (const GeneratedFunction& function : functions) {
    const std::string name = function_name(function.function);
    if (const std::string beyond = beyond_peers(scene, function); !beyond.empty()) {
      made.peer.remarks.push_back(fmt::format("is not asked for {} with {}", name, beyond));
      continue;
    }
    bool found = false;
    for (const PeerRoutine& routine : opened.routines) {
      if (routine.function != name) continue;
      made.contenders.push_back(contender_of(peer, routine, function, timed));
      found = true;
    }
    if (!found) lacking.push_back(name);
  }
  if (!lacking.empty()) {
    made.peer.remarks.push_back(fmt::format("is not adapted for {}", fmt::join(lacking, ", ")));
  }
  return made;
}

}  // namespace treeline
