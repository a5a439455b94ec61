#include "drive/front_end_socket.hpp"

#include <boost/asio/buffer.hpp>
#include <utility>

namespace treeline::drive {

namespace asio = boost::asio;
namespace beast = boost::beast;
namespace websocket = beast::websocket;

FrontEndSocket::FrontEndSocket(Server::Inside& server, asio::ip::tcp::socket socket,
                               bool may_command)
    : server_(server), stream_(std::move(socket)), may_command_(may_command) {}

FrontEndSocket::~FrontEndSocket() {
  server_.leave_place(may_command_);
  if (!joined_) return;
  server_.sockets.erase(front_end_);
  server_.passes.withdraw(pass_);
  --server_.joined;
  if (may_command_) --server_.joined_commanders;
  server_.handlers.leave(front_end_);
}

void FrontEndSocket::run(const Request& request) {
  stream_.set_option(websocket::stream_base::timeout::suggested(beast::role_type::server));
  stream_.read_message_max(kLargestMessage);
  stream_.text(true);
  stream_.async_accept(request, [self = shared_from_this()](beast::error_code error) {
    if (!error) self->join();
  });
}

void FrontEndSocket::join() {
  pass_ = make_token();
  server_.passes.issue(pass_, may_command_);
  std::string hello;
  front_end_ = server_.handlers.join({may_command_, "?pass=" + pass_}, hello);
  joined_ = true;
  server_.sockets[front_end_] = shared_from_this();
  ++server_.joined;
  if (may_command_) ++server_.joined_commanders;
  send(std::move(hello));
  read();
}

void FrontEndSocket::send(std::string text) {
  constexpr std::size_t kMostWaiting = 256;  // replies to a front end that does not read
  if (waiting_.size() >= kMostWaiting) {
    beast::get_lowest_layer(stream_).close();
    return;
  }
  waiting_.push_back(std::move(text));
  if (!writing_) write();
}

void FrontEndSocket::send_state(const std::function<std::string(int)>& text) {
  if (waiting_.empty() && !writing_) send(text(front_end_));
}

void FrontEndSocket::read() {
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

void FrontEndSocket::write() {
  writing_ = true;
  sending_ = std::move(waiting_.front());
  waiting_.pop_front();
  stream_.async_write(asio::buffer(sending_),
                      [self = shared_from_this()](beast::error_code error, std::size_t) {
                        self->writing_ = false;
                        if (!error && !self->waiting_.empty()) self->write();
                      });
}

}  // namespace treeline::drive
