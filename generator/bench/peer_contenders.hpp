#pragma once

#include <filesystem>
#include <vector>

#include "bench/bench_report.hpp"
#include "bench/contender.hpp"
#include "bench/peers/load_peer.hpp"

namespace treeline {

/// What a peer does of a scene's functions, and what is to be said about the rest.
struct PeerContenders {
  BenchPeer peer;
  std::vector<Contender> contenders;
};

/// Opens the robot and takes each of the peer's routes to each of the functions; errors of theirs
/// are to be found out. `urdf` is a file with what `print_plain_urdf` says.
PeerContenders peer_contenders(const LoadedPeer& peer, const PeerDescription& description,
                               const std::filesystem::path& urdf, const Scene& scene,
                               const std::vector<GeneratedFunction>& functions,
                               const std::vector<State>& timed);

}  // namespace treeline
