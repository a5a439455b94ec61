#pragma once

#include <filesystem>
#include <vector>

#include "bench/bench_report.hpp"
#include "bench/contender.hpp"
#include "bench/peers/load_peer.hpp"

namespace treeline {

/// Contenders for those of a scene's functions that a peer has, and remarks about the others.
struct PeerContenders {
  BenchPeer peer;
  std::vector<Contender> contenders;
};

/// Opens the robot in the peer's library and makes a contender of each of its routes to each of the
/// functions. Whether its results are right must be checked separately. `urdf` is a file with the
/// text from `print_plain_urdf`.
PeerContenders peer_contenders(const LoadedPeer& peer, const PeerDescription& description,
                               const std::filesystem::path& urdf, const Scene& scene,
                               const std::vector<GeneratedFunction>& functions,
                               const std::vector<State>& timed);

}  // namespace treeline
