#pragma once

#include <boost/beast/core.hpp>
#include <boost/beast/http.hpp>
#include <fstream>
#include <list>
#include <memory>
#include <optional>
#include <string>

#include "drive/page_reply.hpp"
#include "drive/server_inside.hpp"

namespace treeline::drive {

/// A connection that asks for pages, until it becomes the socket of a front end. Lives in the
/// thread of pages; bodies go out slice by slice, and files are read in the thread of files.
class Visitor : public std::enable_shared_from_this<Visitor> {
 public:
  Visitor(Server::Inside& server, boost::asio::ip::tcp::socket socket);
  ~Visitor();
  Visitor(const Visitor&) = delete;
  Visitor& operator=(const Visitor&) = delete;

  /// Enters itself among the server's visitors and reads what is asked for.
  void begin();
  /// Whether its request came with the token, so that it keeps its place while it is answered.
  bool is_trusted() const { return trusted_; }
  /// Gives its place to another.
  void close();

 private:
  void read();
  void respond();
  void become_front_end(bool may_command);
  PageReply find(std::string_view path, std::string_view target);
  PageReply find_mesh(std::size_t number, std::string_view target);
  void open_file();
  void begin_body(const PageReply& reply, std::uint64_t size);
  void send_slice();
  void write_slice(boost::asio::const_buffer slice);
  void end_body();
  void leave();

  Server::Inside& server_;
  boost::beast::tcp_stream stream_;
  boost::beast::flat_buffer buffer_{16384};
  std::optional<boost::beast::http::request_parser<boost::beast::http::empty_body>> parser_;
  PageRequest request_;
  PageReply reply_;
  PageHead head_;
  std::optional<boost::beast::http::response_serializer<boost::beast::http::empty_body>> heading_;
  std::ifstream file_;
  std::string slice_;
  std::uint64_t left_ = 0;  // bytes of the body that were not sent
  std::optional<std::list<std::weak_ptr<Visitor>>::iterator> place_;
  bool trusted_ = false;
};

}  // namespace treeline::drive
