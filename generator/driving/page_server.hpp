#pragma once

#include <memory>
#include <string>
#include <vector>

#include "drive/server.hpp"
#include "drive/wire.hpp"
#include "text/diagnostic.hpp"

namespace treeline {

/// Where the page is served, and for which robot.
struct PageSettings {
  std::string listen = "127.0.0.1";
  int port = 0;  ///< 0: any
  std::string urdf;
  std::vector<drive::ServedMesh> meshes;
};

/// Serves the page that this program carries, and prints its address with the token. Null, with an
/// error, where the address cannot be listened on.
std::unique_ptr<drive::Server> serve_page(const PageSettings& settings,
                                          drive::ServerHandlers handlers, Diagnostics& diagnostics);

}  // namespace treeline
