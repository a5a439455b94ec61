#pragma once

#include <string>
#include <vector>

#include "bench/peers/load_peer.hpp"

namespace treeline {

struct FoundPeers {
  std::vector<LoadedPeer> peers;
  std::vector<std::string> absent;  ///< of those that there are adapters for
};

/// Loads the modules of `files`, then those that lie beside this program or, where it is installed,
/// in its libraries' folder. What is wrong with one of `files` is an error, with another a warning.
FoundPeers find_peers(const std::vector<std::string>& files, Diagnostics& diagnostics);

/// What brings a peer that is absent.
inline constexpr const char* kBringPeers =
    "found beside this program where they are installed and it is built with -DTREELINE_PEERS=ON";

}  // namespace treeline
