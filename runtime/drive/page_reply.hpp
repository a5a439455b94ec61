#pragma once

#include <boost/beast/http.hpp>
#include <cstdint>
#include <string>
#include <string_view>

#include "drive/server.hpp"

namespace treeline::drive {

using PageRequest = boost::beast::http::request<boost::beast::http::empty_body>;
using PageHead = boost::beast::http::response<boost::beast::http::empty_body>;

/// Reply to a request for a page.
struct PageReply {
  boost::beast::http::status status = boost::beast::http::status::ok;
  const char* type = "text/plain";
  std::string_view text;  ///< outlives the server, unless the body is a file
  std::string file;       ///< whose bytes are the body; empty: the body is `text`
};

/// Why a request is not answered, or an empty text: its Host, Origin or Fetch metadata name another
/// site.
std::string_view reason_to_refuse(const PageRequest& request, const std::string& address, int port);

/// The page, the robot, or that there is no such page; meshes are not among these.
PageReply find_page(std::string_view path, const ServerSettings& settings);

/// The number behind `/mesh/`; none of the meshes: `count`.
std::size_t mesh_number(std::string_view path, std::size_t count);

/// The head of an answer with a body of `size` bytes.
PageHead head_of(const PageRequest& request, const PageReply& reply, std::uint64_t size);

/// Value of `name=` in the query of a target, if that is all of the query.
std::string_view query_value(std::string_view target, std::string_view name);

}  // namespace treeline::drive
