#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "drive/wire.hpp"

namespace treeline::drive {

/// Settings of the server: what browsers get, and where.
struct ServerSettings {
  std::string address = "127.0.0.1";     ///< an address of this machine, not a name
  int port = 0;                          ///< 0: any that is free
  std::string token;                     ///< who has it may command
  std::string_view html, script, style;  ///< the page; empty: a page that says so
  std::string urdf;
  std::vector<ServedMesh> meshes;
};

/// Who has connected.
struct NewFrontEnd {
  bool may_command = false;  ///< it came with the token
  std::string mesh_query;    ///< what stands behind the addresses of the meshes in its `hello`
};

/// Requests of the server to the program. They come from the server's thread, one at a time.
struct ServerHandlers {
  /// A front end has connected. Returns its number; `hello` is sent to it first.
  std::function<int(const NewFrontEnd& front_end, std::string& hello)> join;
  /// It has sent a message. Returns the reply; empty: none.
  std::function<std::string(int front_end, std::string_view message)> receive;
  std::function<void(int front_end)> leave;
};

/// Places for front ends with the token, and as many for those without.
inline constexpr int kMostFrontEnds = 32;
/// Connections that ask for pages at a time. One more takes the place of the oldest that has not
/// shown the token.
inline constexpr std::size_t kMostVisitors = 32;

/// HTTP and WebSocket for the page, in threads of its own. It serves the page, the robot and its
/// meshes, and nothing else; see docs/reference/wire.md for what it checks.
class Server {
 public:
  /// Null where the address cannot be listened on; `error` says why.
  static std::unique_ptr<Server> open(ServerSettings settings, ServerHandlers handlers,
                                      std::string& error);
  ~Server();
  Server(const Server&) = delete;
  Server& operator=(const Server&) = delete;

  int port() const;
  int connections() const;     ///< front ends
  int commanders() const;      ///< front ends that may command
  int failed_accepts() const;  ///< for want of file descriptors; each is followed by a pause
  /// Sends every front end what `text` makes for it. A front end that still has an older state to
  /// be sent misses this one.
  void send_states(const std::function<std::string(int front_end)>& text);
  void send(int front_end, std::string text);

  struct Inside;  ///< of the source file

 private:
  explicit Server(std::unique_ptr<Inside> inside);
  std::unique_ptr<Inside> inside_;
};

/// Whether a `Host` header names this server: an address as a number, or localhost, and its port. A
/// name that an attacker's name server resolves to this machine is none.
bool is_own_host(std::string_view host, std::string_view address, int port);
/// Whether an `Origin` is the page of the server that `host` names.
bool is_own_origin(std::string_view origin, std::string_view host);

/// Headers of a browser's request: `Sec-Fetch-Site` and `Sec-Fetch-Mode`; empty: none.
struct FetchMetadata {
  std::string_view site, mode;
};
/// Whether a request may come from where the browser says. A link of another site may lead to the
/// page, and nothing of that site may load anything from here.
bool is_own_fetch(const FetchMetadata& metadata, std::string_view path);

/// Compares in a time that tells nothing of where two texts differ.
bool is_same_secret(std::string_view a, std::string_view b);

/// 128 random bits, 32 hexadecimal digits. Throws std::system_error if the machine gives none.
std::string make_token();

}  // namespace treeline::drive
