#include "drive/server.hpp"

#include <atomic>
#include <boost/asio/bind_executor.hpp>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/post.hpp>
#include <boost/asio/strand.hpp>
#include <boost/beast/core.hpp>
#include <boost/beast/http.hpp>
#include <boost/beast/websocket.hpp>
#include <charconv>
#include <deque>
#include <fstream>
#include <iterator>
#include <map>
#include <optional>
#include <thread>
#include <utility>

#include "servo/realtime.hpp"

namespace treeline::drive {
namespace {

namespace asio = boost::asio;
namespace beast = boost::beast;
namespace http = beast::http;
namespace websocket = beast::websocket;
using tcp = asio::ip::tcp;
using Request = http::request<http::empty_body>;
using Response = http::response<http::string_body>;

constexpr std::size_t kMostConnections = 32;
constexpr std::size_t kMostWaiting = 256;  // replies to a front end that does not read

constexpr const char* kNoPage =
    "<!doctype html><title>treeline drive</title><p>This program was built without the page: "
    "Node.js and npm were missing, or `npm ci` failed. Commands work: see standard input, "
    "<code>--script</code>, and the messages of <code>/socket</code>.";

/// Compares in a time that tells nothing of where two texts differ.
bool same_secret(std::string_view a, std::string_view b) {
  if (a.size() != b.size()) return false;
  unsigned difference = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    difference |= static_cast<unsigned>(a[i] ^ b[i]);
  }
  return difference == 0;
}

std::string_view view(beast::string_view text) {
  return {text.data(), text.size()};
}

Response answer(const Request& request, http::status status, const char* type, std::string body) {
  Response response{status, request.version()};
  response.set(http::field::content_type, type);
  response.set(http::field::cache_control, "no-store");
  response.set("X-Content-Type-Options", "nosniff");
  response.set("X-Frame-Options", "DENY");
  response.set("Referrer-Policy", "no-referrer");
  response.set("Cross-Origin-Resource-Policy", "same-origin");
  response.set("Content-Security-Policy",
               "default-src 'self'; connect-src 'self' ws: blob: data:; style-src 'self' "
               "'unsafe-inline'; img-src 'self' data: blob:; worker-src 'self' blob:; "
               "object-src 'none'; base-uri 'none'; frame-ancestors 'none'");
  response.keep_alive(request.keep_alive());
  response.body() = std::move(body);
  response.prepare_payload();
  return response;
}

/// The number behind `/mesh/`, if it is one of the meshes.
std::optional<std::size_t> mesh_number(std::string_view path, std::size_t count) {
  constexpr std::string_view kPrefix = "/mesh/";
  if (!path.starts_with(kPrefix)) return std::nullopt;
  const std::string_view digits = path.substr(kPrefix.size());
  std::size_t number = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), number);
  if (error != std::errc{} || end != digits.data() + digits.size() || number >= count) {
    return std::nullopt;
  }
  return number;
}

class Socket;

}  // namespace

struct Server::Inside {
  Inside(ServerSettings s, ServerHandlers h)
      : settings(std::move(s)), handlers(std::move(h)), acceptor(context) {}

  ServerSettings settings;
  ServerHandlers handlers;
  // What connections use when they end is declared before the context, which ends them.
  std::map<int, std::weak_ptr<Socket>> sockets;  // only in the server's thread
  std::atomic<int> count{0};                     // of sockets
  std::size_t connections = 0;                   // of all kinds; only in the server's thread
  int port = 0;
  asio::io_context context{1};
  tcp::acceptor acceptor;
  std::thread thread;

  void accept();
  Response respond(const Request& request) const;
};

namespace {

/// A front end on a WebSocket.
class Socket : public std::enable_shared_from_this<Socket> {
 public:
  Socket(Server::Inside& server, tcp::socket socket, bool may_command)
      : server_(server), stream_(std::move(socket)), may_command_(may_command) {}
  ~Socket() {
    --server_.connections;
    if (!joined_) return;
    server_.sockets.erase(front_end_);
    --server_.count;
    server_.handlers.leave(front_end_);
  }
  Socket(const Socket&) = delete;
  Socket& operator=(const Socket&) = delete;

  void run(const Request& request) {
    stream_.set_option(websocket::stream_base::timeout::suggested(beast::role_type::server));
    stream_.read_message_max(kLargestMessage);
    stream_.text(true);
    stream_.async_accept(request, [self = shared_from_this()](beast::error_code error) {
      if (error) return;
      std::string hello;
      self->front_end_ = self->server_.handlers.join(self->may_command_, hello);
      self->joined_ = true;
      self->server_.sockets[self->front_end_] = self;
      ++self->server_.count;
      self->send(std::move(hello));
      self->read();
    });
  }

  void send(std::string text) {
    if (waiting_.size() >= kMostWaiting) {
      beast::get_lowest_layer(stream_).close();
      return;
    }
    waiting_.push_back(std::move(text));
    if (!writing_) write();
  }

  /// A state, unless the one before has not been sent.
  void send_state(const std::function<std::string(int)>& text) {
    if (waiting_.empty() && !writing_) send(text(front_end_));
  }

 private:
  void read() {
    stream_.async_read(buffer_, [self = shared_from_this()](beast::error_code error, std::size_t) {
      if (error) {
        beast::get_lowest_layer(self->stream_).close();
        return;
      }
      const std::string message = beast::buffers_to_string(self->buffer_.data());
      self->buffer_.consume(self->buffer_.size());
      std::string reply = self->server_.handlers.receive(self->front_end_, message);
      if (!reply.empty()) self->send(std::move(reply));
      self->read();
    });
  }

  void write() {
    writing_ = true;
    sending_ = std::move(waiting_.front());
    waiting_.pop_front();
    stream_.async_write(asio::buffer(sending_),
                        [self = shared_from_this()](beast::error_code error, std::size_t) {
                          self->writing_ = false;
                          if (!error && !self->waiting_.empty()) self->write();
                        });
  }

  Server::Inside& server_;
  websocket::stream<beast::tcp_stream> stream_;
  beast::flat_buffer buffer_;
  std::deque<std::string> waiting_;
  std::string sending_;
  bool may_command_;
  bool joined_ = false;
  bool writing_ = false;
  int front_end_ = 0;
};

/// A connection that asks for pages, until it becomes a socket.
class Visitor : public std::enable_shared_from_this<Visitor> {
 public:
  Visitor(Server::Inside& server, tcp::socket socket)
      : server_(server), stream_(std::move(socket)) {
    ++server_.connections;
  }
  ~Visitor() {
    if (!became_socket_) --server_.connections;
  }
  Visitor(const Visitor&) = delete;
  Visitor& operator=(const Visitor&) = delete;

  void read() {
    parser_.emplace();
    parser_->body_limit(0);
    parser_->header_limit(8192);
    stream_.expires_after(std::chrono::seconds(30));
    http::async_read(stream_, buffer_, *parser_,
                     [self = shared_from_this()](beast::error_code error, std::size_t) {
                       if (!error) self->respond();
                     });
  }

 private:
  bool is_permitted(const Request& request) const {
    const std::string_view host = view(request[http::field::host]);
    if (!is_own_host(host, server_.settings.address, server_.port)) return false;
    const auto origin = request.find(http::field::origin);
    return origin == request.end() || is_own_origin(view(origin->value()), host);
  }

  void respond() {
    const Request request = parser_->release();
    if (!is_permitted(request)) {
      return write(answer(request, http::status::forbidden, "text/plain",
                          "Host or Origin is not this server.\n"));
    }
    const std::string_view target = view(request.target());
    const std::string_view path = target.substr(0, target.find('?'));
    if (path == "/socket" && websocket::is_upgrade(request)) {
      constexpr std::string_view kQuery = "/socket?token=";
      const bool may_command = target.starts_with(kQuery) &&
                               same_secret(target.substr(kQuery.size()), server_.settings.token);
      became_socket_ = true;
      stream_.expires_never();
      std::make_shared<Socket>(server_, stream_.release_socket(), may_command)->run(request);
      return;
    }
    write(server_.respond(request));
  }

  void write(Response response) {
    response_ = std::move(response);
    http::async_write(stream_, response_,
                      [self = shared_from_this()](beast::error_code error, std::size_t) {
                        if (error) return;
                        if (self->response_.keep_alive()) return self->read();
                        beast::error_code ignored;  // the other side may have closed already
                        self->stream_.socket().shutdown(tcp::socket::shutdown_send, ignored);
                      });
  }

  Server::Inside& server_;
  beast::tcp_stream stream_;
  beast::flat_buffer buffer_{16384};
  std::optional<http::request_parser<http::empty_body>> parser_;
  Response response_;
  bool became_socket_ = false;
};

std::string read_mesh(const std::string& path) {
  std::ifstream stream(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

}  // namespace

Response Server::Inside::respond(const Request& request) const {
  if (request.method() != http::verb::get) {
    return answer(request, http::status::method_not_allowed, "text/plain", "Only GET.\n");
  }
  const std::string_view target = view(request.target());
  const std::string_view path = target.substr(0, target.find('?'));
  const auto ok = [&](const char* type, std::string_view body) {
    return answer(request, http::status::ok, type, std::string(body));
  };
  if (path == "/")
    return ok("text/html; charset=utf-8", settings.html.empty() ? kNoPage : settings.html);
  if (path == "/page.js" && !settings.html.empty()) {
    return ok("text/javascript; charset=utf-8", settings.script);
  }
  if (path == "/page.css" && !settings.html.empty()) {
    return ok("text/css; charset=utf-8", settings.style);
  }
  if (path == "/robot.urdf") return ok("application/xml", settings.urdf);
  const auto mesh = mesh_number(path, settings.meshes.size());
  if (mesh && !settings.meshes[*mesh].path.empty()) {
    return ok("application/octet-stream", read_mesh(settings.meshes[*mesh].path));
  }
  return answer(request, http::status::not_found, "text/plain", "There is no such page.\n");
}

void Server::Inside::accept() {
  acceptor.async_accept([this](beast::error_code error, tcp::socket socket) {
    if (error == asio::error::operation_aborted) return;
    if (!error && connections < kMostConnections) {
      beast::error_code ignored;  // only slower without it
      socket.set_option(tcp::no_delay(true), ignored);
      std::make_shared<Visitor>(*this, std::move(socket))->read();
    }
    accept();
  });
}

Server::Server(std::unique_ptr<Inside> inside) : inside_(std::move(inside)) {
  inside_->accept();
  inside_->thread = std::thread([this] {
    servo::request_attention();
    inside_->context.run();
  });
}

Server::~Server() {
  inside_->context.stop();
  inside_->thread.join();
}

std::unique_ptr<Server> Server::open(ServerSettings settings, ServerHandlers handlers,
                                     std::string& error) {
  auto inside = std::make_unique<Inside>(std::move(settings), std::move(handlers));
  beast::error_code code;
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
  return inside_->count;
}

void Server::send_states(const std::function<std::string(int)>& text) {
  asio::post(inside_->context, [this, text] {
    for (const auto& [front_end, socket] : inside_->sockets) {
      if (const auto alive = socket.lock()) alive->send_state(text);
    }
  });
}

void Server::send(int front_end, std::string text) {
  asio::post(inside_->context, [this, front_end, text = std::move(text)] {
    const auto found = inside_->sockets.find(front_end);
    if (found == inside_->sockets.end()) return;
    if (const auto alive = found->second.lock()) alive->send(text);
  });
}

}  // namespace treeline::drive
