#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "bench/peers/describe_to_peers.hpp"
#include "bench/peers/peer.hpp"
#include "text/diagnostic.hpp"

namespace treeline {

/// A peer's module in this process. It stays loaded, because large libraries are not made to be
/// unloaded.
struct LoadedPeer {
  std::string name;     ///< "KDL"
  std::string release;  ///< "1.5.1"
  std::string file;     ///< path of the module
  const peer::Peer* functions = nullptr;
};

/// Loads the module at `path`. Errors: those of the loader; the file is not a module of a peer; its
/// version of the interface differs from this program's.
std::optional<LoadedPeer> load_peer(const std::filesystem::path& path, Diagnostics& diagnostics);

/// One of the peer's routes to a function, for the robot that it was opened for.
struct PeerRoutine {
  std::string function, route;
  std::shared_ptr<void> solver;  ///< keeps everything of the opened robot alive
  peer::Call call = nullptr;
  peer::Finish finish = nullptr;
};

struct OpenedPeer {
  std::vector<PeerRoutine> routines;   ///< empty if the peer cannot handle the robot
  std::vector<std::string> sentences;  ///< what it cannot do, and why: "has no floating base"
};

/// Opens a robot for functions of these names. `urdf` has the text from `print_plain_urdf`. What
/// the library prints on standard output goes to standard error.
OpenedPeer open_peer(const LoadedPeer& peer, const std::filesystem::path& urdf,
                     const PeerDescription& description, const std::vector<std::string>& functions);

}  // namespace treeline
