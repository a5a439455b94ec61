#pragma once

#include <string>
#include <vector>

#include "bench/peers/load_peer.hpp"

namespace treeline {

struct FoundPeers {
  std::vector<LoadedPeer> peers;
  std::vector<std::string> absent;  ///< known peers that were not found
};

/// Loads the modules `files`, and those beside this program or, if it is installed, in its library
/// folder. A fault is an error for one of `files` and a warning for the others.
FoundPeers find_peers(const std::vector<std::string>& files, Diagnostics& diagnostics);

/// Advice for getting an absent peer.
inline constexpr const char* kBringPeers =
    "found beside this program where they are installed and it is built with -DTREELINE_PEERS=ON";

}  // namespace treeline
