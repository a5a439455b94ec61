#include "driving/page_server.hpp"

#include <fmt/format.h>

#include <cstdio>

#include "drive/page.hpp"
#include "terminal/write_output.hpp"

namespace treeline {

std::unique_ptr<drive::Server> serve_page(const PageSettings& settings,
                                          drive::ServerHandlers handlers,
                                          Diagnostics& diagnostics) {
  const drive::Page page = drive::carried_page();
  drive::ServerSettings server;
  server.address = settings.listen;
  server.port = settings.port;
  server.token = drive::make_token();
  server.html = page.html;
  server.script = page.script;
  server.style = page.style;
  server.urdf = settings.urdf;
  server.meshes = settings.meshes;
  const std::string token = server.token;
  std::string error;
  auto opened = drive::Server::open(std::move(server), std::move(handlers), error);
  if (!opened) {
    diagnostics.add(
        {Severity::error, "", 0, "--listen",
         fmt::format("{} port {} cannot be listened on: {}", settings.listen, settings.port, error),
         "Choose another --port, or an address of this machine."});
    return nullptr;
  }
  if (page.html.empty()) {
    print_message("This program was built without the page: Node.js or npm was missing.\n");
  }
  const bool is_ipv6 = settings.listen.find(':') != std::string::npos;
  fmt::print("http://{}:{}/?token={}\n", is_ipv6 ? "[" + settings.listen + "]" : settings.listen,
             opened->port(), token);
  std::fflush(stdout);
  return opened;
}

}  // namespace treeline
