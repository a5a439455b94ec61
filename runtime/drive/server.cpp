#include "drive/server.hpp"

#include <boost/asio/error.hpp>
#include <boost/asio/ip/address.hpp>
#include <boost/asio/post.hpp>
#include <chrono>
#include <utility>

#include "drive/front_end_socket.hpp"
#include "drive/machine_time.hpp"
#include "drive/server_inside.hpp"
#include "drive/visitor.hpp"
#include "servo/realtime.hpp"

namespace treeline::drive {

namespace asio = boost::asio;
using boost::system::error_code;
using tcp = asio::ip::tcp;

Server::Inside::~Inside() {
  front_ends.stop();
  pages.stop();
  files.stop();
  if (obeying.joinable()) obeying.join();
  if (paging.joinable()) paging.join();
  files.join();
}

void Server::Inside::run() {
  accept();
  obeying = std::thread([this] {
    servo::request_attention();
    front_ends.run();
  });
  paging = std::thread([this] { pages.run(); });
}

bool Server::Inside::take_place(bool may_command) {
  if (!may_command && !joins.admits(machine_time())) return false;
  std::atomic<int>& taken = may_command ? commanders : watchers;
  if (++taken <= kMostFrontEnds) return true;
  --taken;
  return false;
}

void Server::Inside::leave_place(bool may_command) {
  --(may_command ? commanders : watchers);
}

/// Room for one more: where all places are taken, the visitor that waits longest without the token
/// gives its own up. False: all have the token.
bool Server::Inside::make_room() {
  if (visitors.size() < kMostVisitors) return true;
  for (const std::weak_ptr<Visitor>& place : visitors) {
    const std::shared_ptr<Visitor> visitor = place.lock();
    if (!visitor || visitor->is_trusted()) continue;
    visitor->close();
    return true;
  }
  return false;
}

void Server::Inside::welcome(tcp::socket socket) {
  if (!make_room()) return;
  error_code ignored;  // only slower without it
  socket.set_option(tcp::no_delay(true), ignored);
  std::make_shared<Visitor>(*this, std::move(socket))->begin();
}

void Server::Inside::accept() {
  acceptor.async_accept([this](error_code error, tcp::socket socket) {
    if (error == asio::error::operation_aborted) return;
    if (!error) {
      welcome(std::move(socket));
      return accept();
    }
    ++failed_accepts;  // mostly for want of file descriptors: others have to be closed first
    again.expires_after(std::chrono::milliseconds(100));
    again.async_wait([this](error_code ended) {
      if (!ended) accept();
    });
  });
}

Server::Server(std::unique_ptr<Inside> inside) : inside_(std::move(inside)) {
  inside_->run();
}

Server::~Server() = default;

std::unique_ptr<Server> Server::open(ServerSettings settings, ServerHandlers handlers,
                                     std::string& error) {
  auto inside = std::make_unique<Inside>(std::move(settings), std::move(handlers));
  error_code code;
  const auto address = asio::ip::make_address(inside->settings.address, code);
  const auto port = static_cast<unsigned short>(inside->settings.port);
  const tcp::endpoint endpoint(address, port);
  if (!code) inside->acceptor.open(endpoint.protocol(), code);
  if (!code) inside->acceptor.set_option(asio::socket_base::reuse_address(true), code);
  if (!code) inside->acceptor.bind(endpoint, code);
  if (!code) inside->acceptor.listen(asio::socket_base::max_listen_connections, code);
  if (code) {
    error = code.message();
    return nullptr;
  }
  inside->port = inside->acceptor.local_endpoint().port();
  return std::unique_ptr<Server>(new Server(std::move(inside)));
}

int Server::port() const {
  return inside_->port;
}

int Server::connections() const {
  return inside_->joined;
}

int Server::commanders() const {
  return inside_->joined_commanders;
}

int Server::failed_accepts() const {
  return inside_->failed_accepts;
}

void Server::send_states(const std::function<std::string(int)>& text) {
  asio::post(inside_->front_ends, [this, text] {
    for (const auto& [front_end, socket] : inside_->sockets) {
      if (const auto alive = socket.lock()) alive->send_state(text);
    }
  });
}

void Server::send(int front_end, std::string text) {
  asio::post(inside_->front_ends, [this, front_end, text = std::move(text)] {
    const auto found = inside_->sockets.find(front_end);
    if (found == inside_->sockets.end()) return;
    if (const auto alive = found->second.lock()) alive->send(text);
  });
}

}  // namespace treeline::drive
