#include <algorithm>
#include <iostream>

#include "bench/peers/load_peer.hpp"
#include "peers.hpp"

namespace treeline::bench {
namespace {

/// Measured functions by name.
std::map<std::string, Function> functions_by_name() {
  std::map<std::string, Function> functions;
  for (const Function function : kFunctions) functions[name_of(function)] = function;
  return functions;
}

void add_subjects(const LoadedPeer& peer, const Case& robot, std::vector<Subject>& subjects) {
  static const auto kByName = functions_by_name();
  const OpenedPeer opened = open_peer(peer, robot.urdf, robot.description);
  for (const std::string& sentence : opened.sentences) {
    std::cerr << robot.robot << ": " << peer.name << ' ' << sentence << '\n';
  }
  for (const PeerRoutine& routine : opened.routines) {
    const auto function = kByName.find(routine.function);
    if (function == kByName.end()) continue;
    const std::string name = peer.name + (routine.route.empty() ? "" : ", " + routine.route);
    auto subject = std::ranges::find(subjects, name, &Subject::implementation);
    if (subject == subjects.end()) subject = subjects.insert(subjects.end(), {name, {}});
    subject->routines[function->second] = {routine.call, routine.solver, 1, routine.finish};
  }
}

}  // namespace

std::vector<Subject> peer_subjects(const Case& robot) {
  std::vector<Subject> subjects;
  Diagnostics diagnostics;
  const std::vector<const char*> modules = {TREELINE_PEER_FILES};
  for (const char* module : modules) {
    if (const auto peer = load_peer(module, diagnostics)) add_subjects(*peer, robot, subjects);
  }
  for (const Diagnostic& diagnostic : diagnostics.list())
    std::cerr << to_string(diagnostic) << '\n';
  return subjects;
}

}  // namespace treeline::bench
