#include "drive/visitor.hpp"

#include <algorithm>
#include <boost/asio/post.hpp>
#include <boost/asio/write.hpp>
#include <chrono>
#include <utility>

#include "drive/front_end_socket.hpp"

namespace treeline::drive {
namespace {

namespace asio = boost::asio;
namespace beast = boost::beast;
namespace http = beast::http;
using tcp = asio::ip::tcp;

constexpr std::size_t kSlice = 65536;                 // bytes that one connection holds at most
constexpr auto kPatience = std::chrono::seconds(30);  // for a request, and for each slice

}  // namespace

Visitor::Visitor(Server::Inside& server, tcp::socket socket)
    : server_(server), stream_(std::move(socket)) {}

Visitor::~Visitor() {
  leave();
}

void Visitor::begin() {
  place_ = server_.visitors.insert(server_.visitors.end(), weak_from_this());
  read();
}

void Visitor::leave() {
  if (place_) server_.visitors.erase(*place_);
  place_.reset();
}

void Visitor::close() {
  leave();
  stream_.close();
}

void Visitor::read() {
  trusted_ = false;
  parser_.emplace();
  parser_->body_limit(0);
  parser_->header_limit(8192);
  stream_.expires_after(kPatience);
  http::async_read(stream_, buffer_, *parser_,
                   [self = shared_from_this()](beast::error_code error, std::size_t) {
                     if (!error) self->respond();
                   });
}

void Visitor::respond() {
  request_ = parser_->release();
  const std::string_view target{request_.target().data(), request_.target().size()};
  const std::string_view path = target.substr(0, target.find('?'));
  const std::string_view refusal =
      reason_to_refuse(request_, server_.settings.address, server_.port);
  if (!refusal.empty()) {
    reply_ = {http::status::forbidden, "text/plain", refusal, {}};
  } else if (path == "/socket" && beast::websocket::is_upgrade(request_)) {
    const bool may_command = is_same_secret(query_value(target, "token"), server_.settings.token);
    if (server_.take_place(may_command)) return become_front_end(may_command);
    reply_ = {http::status::service_unavailable,
              "text/plain",
              "All places of front ends are taken, or too many come at once.\n",
              {}};
  } else {
    reply_ = find(path, target);
  }
  if (!reply_.file.empty()) return open_file();
  begin_body(reply_, reply_.text.size());
}

PageReply Visitor::find(std::string_view path, std::string_view target) {
  if (request_.method() != http::verb::get) {
    return {http::status::method_not_allowed, "text/plain", "Only GET.\n", {}};
  }
  trusted_ = is_same_secret(query_value(target, "token"), server_.settings.token);
  const std::size_t number = mesh_number(path, server_.settings.meshes.size());
  if (number < server_.settings.meshes.size()) return find_mesh(number, target);
  return find_page(path, server_.settings);
}

PageReply Visitor::find_mesh(std::size_t number, std::string_view target) {
  const MeshPasses::Answer answer = trusted_
                                        ? MeshPasses::Answer::always
                                        : server_.passes.ask(query_value(target, "pass"), number);
  if (answer == MeshPasses::Answer::refused) {
    return {http::status::forbidden,
            "text/plain",
            "A mesh is given with the token, and to each front end once: its address is in "
            "`hello`.\n",
            {}};
  }
  trusted_ = answer == MeshPasses::Answer::always;
  const std::string& file = server_.settings.meshes[number].path;
  if (file.empty()) return {http::status::not_found, "text/plain", "There is no such mesh.\n", {}};
  return {http::status::ok, "application/octet-stream", {}, file};
}

void Visitor::become_front_end(bool may_command) {
  leave();
  stream_.expires_never();
  tcp::socket here = stream_.release_socket();
  const auto protocol = server_.acceptor.local_endpoint().protocol();
  auto socket = std::make_shared<FrontEndSocket>(
      server_, tcp::socket(server_.front_ends, protocol, here.release()), may_command);
  asio::post(server_.front_ends,
             [socket = std::move(socket), request = request_] { socket->run(request); });
}

// The thread of files hands the visitor back: it is to end in the thread of pages.
void Visitor::open_file() {
  asio::post(server_.files, [self = shared_from_this()]() mutable {
    self->file_ = std::ifstream(self->reply_.file, std::ios::binary | std::ios::ate);
    const std::streamoff size = self->file_ ? std::streamoff(self->file_.tellg()) : -1;
    self->file_.seekg(0);
    asio::io_context& pages = self->server_.pages;
    asio::post(pages, [self = std::move(self), size] {
      if (size >= 0) return self->begin_body(self->reply_, static_cast<std::uint64_t>(size));
      self->reply_ = {http::status::not_found, "text/plain", "This mesh cannot be read.\n", {}};
      self->begin_body(self->reply_, self->reply_.text.size());
    });
  });
}

void Visitor::begin_body(const PageReply& reply, std::uint64_t size) {
  left_ = size;
  head_ = head_of(request_, reply, size);
  heading_.emplace(head_);
  stream_.expires_after(kPatience);
  http::async_write_header(stream_, *heading_,
                           [self = shared_from_this()](beast::error_code error, std::size_t) {
                             if (!error) self->send_slice();
                           });
}

void Visitor::send_slice() {
  if (left_ == 0) return end_body();
  const auto size = static_cast<std::size_t>(std::min<std::uint64_t>(kSlice, left_));
  if (reply_.file.empty()) {
    const std::string_view rest = reply_.text.substr(reply_.text.size() - left_);
    return write_slice(asio::buffer(rest.data(), size));
  }
  asio::post(server_.files, [self = shared_from_this(), size]() mutable {
    self->slice_.resize(size);
    self->file_.read(self->slice_.data(), static_cast<std::streamsize>(size));
    const bool whole = self->file_.gcount() == static_cast<std::streamsize>(size);
    asio::io_context& pages = self->server_.pages;
    asio::post(pages, [self = std::move(self), whole] {
      if (!whole) return self->close();  // the file became shorter
      self->write_slice(asio::buffer(self->slice_));
    });
  });
}

void Visitor::write_slice(asio::const_buffer slice) {
  stream_.expires_after(kPatience);
  asio::async_write(stream_, slice,
                    [self = shared_from_this()](beast::error_code error, std::size_t count) {
                      if (error) return;
                      self->left_ -= count;
                      self->send_slice();
                    });
}

void Visitor::end_body() {
  file_ = {};
  slice_ = {};
  if (head_.keep_alive()) return read();
  beast::error_code ignored;  // the other side may have closed already
  stream_.socket().shutdown(tcp::socket::shutdown_send, ignored);
}

}  // namespace treeline::drive
