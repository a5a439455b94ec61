#pragma once

#include <boost/beast/core.hpp>
#include <boost/beast/http.hpp>
#include <boost/beast/websocket.hpp>
#include <deque>
#include <functional>
#include <memory>
#include <string>

#include "drive/server_inside.hpp"

namespace treeline::drive {

/// A front end on a WebSocket, whose place was taken by `take_place`. Lives in the thread of front
/// ends.
class FrontEndSocket : public std::enable_shared_from_this<FrontEndSocket> {
 public:
  using Request = boost::beast::http::request<boost::beast::http::empty_body>;

  FrontEndSocket(Server::Inside& server, boost::asio::ip::tcp::socket socket, bool may_command);
  ~FrontEndSocket();
  FrontEndSocket(const FrontEndSocket&) = delete;
  FrontEndSocket& operator=(const FrontEndSocket&) = delete;

  void run(const Request& request);
  void send(std::string text);
  /// A state, unless the one before has not been sent.
  void send_state(const std::function<std::string(int)>& text);

 private:
  void join();
  void read();
  void write();

  Server::Inside& server_;
  boost::beast::websocket::stream<boost::beast::tcp_stream> stream_;
  boost::beast::flat_buffer buffer_;
  std::deque<std::string> waiting_;
  std::string sending_;
  std::string pass_;
  bool may_command_;
  bool joined_ = false;
  bool writing_ = false;
  int front_end_ = 0;
};

}  // namespace treeline::drive
