#include "bench/find_peers.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace treeline {
namespace {

struct KnownPeer {
  const char* name;
  const char* module;
};
constexpr std::array kKnown = {KnownPeer{"KDL", "treeline_peer_kdl.so"},
                               KnownPeer{"DART", "treeline_peer_dart.so"},
                               KnownPeer{"Pinocchio", "treeline_peer_pinocchio.so"},
                               KnownPeer{"MuJoCo", "treeline_peer_mujoco.so"},
                               KnownPeer{"dynibo", "treeline_peer_dynibo.so"},
                               KnownPeer{"CasADi", "treeline_peer_casadi.so"}};

bool is_among(const std::vector<LoadedPeer>& peers, const std::string& name) {
  return std::any_of(peers.begin(), peers.end(),
                     [&](const LoadedPeer& peer) { return peer.name == name; });
}

/// Folders in which modules are built and in which they are installed.
std::vector<std::filesystem::path> folders() {
  std::error_code failed;
  const auto program = std::filesystem::read_symlink("/proc/self/exe", failed);
  if (failed) return {};
  const auto folder = program.parent_path();
  return {folder, folder / TREELINE_PEERS_FROM_PROGRAM};
}

void load_known(const KnownPeer& known, std::vector<LoadedPeer>& peers, Diagnostics& diagnostics) {
  for (const auto& folder : folders()) {
    const auto module = folder / known.module;
    if (is_among(peers, known.name) || !std::filesystem::exists(module)) continue;
    Diagnostics own;
    if (auto peer = load_peer(module, own)) peers.push_back(std::move(*peer));
    for (Diagnostic diagnostic : own.list()) {
      diagnostic.severity = Severity::warning;
      diagnostics.add(std::move(diagnostic));
    }
  }
}

}  // namespace

FoundPeers find_peers(const std::vector<std::string>& files, Diagnostics& diagnostics) {
  FoundPeers found;
  for (const std::string& file : files) {
    if (auto peer = load_peer(file, diagnostics)) found.peers.push_back(std::move(*peer));
  }
  for (const KnownPeer& known : kKnown) {
    load_known(known, found.peers, diagnostics);
    if (!is_among(found.peers, known.name)) found.absent.emplace_back(known.name);
  }
  return found;
}

}  // namespace treeline
