#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "bench/peers/describe_to_peers.hpp"
#include "bench/peers/peer.hpp"
#include "description/diagnostic.hpp"

namespace treeline {

/// A peer's module in this process. It stays loaded: libraries of such size are not made to leave.
struct LoadedPeer {
  std::string name;     ///< "KDL"
  std::string release;  ///< "1.5.1"
  std::string file;     ///< of the module
  const peer::Peer* functions = nullptr;
};

/// Loads the module at `path`. Errors: the loader's; no module of a peer; another version of the
/// interface than this program's.
std::optional<LoadedPeer> load_peer(const std::filesystem::path& path, Diagnostics& diagnostics);

/// One way of a peer to a function of the robot that it was opened for.
struct PeerRoutine {
  std::string function, route;
  std::shared_ptr<void> solver;  ///< keeps all of the opened robot
  peer::Call call = nullptr;
  peer::Finish finish = nullptr;
};

struct OpenedPeer {
  std::vector<PeerRoutine> routines;   ///< none where the peer cannot do the robot
  std::vector<std::string> sentences;  ///< what it cannot do, and why: "has no floating base"
};

/// Opens a robot, the URDF of which is that of `print_plain_urdf`. What the library prints on
/// standard output goes to standard error.
OpenedPeer open_peer(const LoadedPeer& peer, const std::filesystem::path& urdf,
                     const PeerDescription& description);

}  // namespace treeline
