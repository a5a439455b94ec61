#include "drive/page_reply.hpp"

#include <charconv>

namespace treeline::drive {
namespace {

namespace beast = boost::beast;
namespace http = beast::http;

constexpr const char* kNoPage =
    "<!doctype html><title>treeline drive</title><p>This program was built without the page: "
    "Node.js and npm were missing, or `npm ci` failed. Commands work: see standard input, "
    "<code>--script</code>, and the messages of <code>/socket</code>.";

std::string_view view(beast::string_view text) {
  return {text.data(), text.size()};
}

}  // namespace

std::string_view reason_to_refuse(const PageRequest& request, const std::string& address,
                                  int port) {
  const std::string_view host = view(request[http::field::host]);
  const auto origin = request.find(http::field::origin);
  if (!is_own_host(host, address, port) ||
      (origin != request.end() && !is_own_origin(view(origin->value()), host))) {
    return "Host or Origin is not this server.\n";
  }
  const std::string_view target = view(request.target());
  const FetchMetadata metadata{view(request["Sec-Fetch-Site"]), view(request["Sec-Fetch-Mode"])};
  if (!is_own_fetch(metadata, target.substr(0, target.find('?')))) {
    return "The page of another site asks for this.\n";
  }
  return {};
}

std::size_t mesh_number(std::string_view path, std::size_t count) {
  constexpr std::string_view kPrefix = "/mesh/";
  if (!path.starts_with(kPrefix)) return count;
  const std::string_view digits = path.substr(kPrefix.size());
  std::size_t number = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), number);
  const bool whole = error == std::errc{} && end == digits.data() + digits.size();
  return whole && number < count ? number : count;
}

std::string_view query_value(std::string_view target, std::string_view name) {
  const std::size_t at = target.find('?');
  if (at == std::string_view::npos) return {};
  const std::string_view query = target.substr(at + 1);
  if (!query.starts_with(name) || query.substr(name.size(), 1) != "=") return {};
  return query.substr(name.size() + 1);
}

PageReply find_page(std::string_view path, const ServerSettings& settings) {
  const bool carried = !settings.html.empty();
  if (path == "/") {
    return {http::status::ok, "text/html; charset=utf-8", carried ? settings.html : kNoPage, {}};
  }
  if (path == "/page.js" && carried) {
    return {http::status::ok, "text/javascript; charset=utf-8", settings.script, {}};
  }
  if (path == "/page.css" && carried) {
    return {http::status::ok, "text/css; charset=utf-8", settings.style, {}};
  }
  if (path == "/robot.urdf") return {http::status::ok, "application/xml", settings.urdf, {}};
  return {http::status::not_found, "text/plain", "There is no such page.\n", {}};
}

PageHead head_of(const PageRequest& request, const PageReply& reply, std::uint64_t size) {
  PageHead head{reply.status, request.version()};
  head.set(http::field::content_type, reply.type);
  head.set(http::field::cache_control, "no-store");
  head.set("X-Content-Type-Options", "nosniff");
  head.set("X-Frame-Options", "DENY");
  head.set("Referrer-Policy", "no-referrer");
  head.set("Cross-Origin-Resource-Policy", "same-origin");
  head.set("Content-Security-Policy",
           "default-src 'self'; connect-src 'self' ws: blob: data:; style-src 'self' "
           "'unsafe-inline'; img-src 'self' data: blob:; worker-src 'self' blob:; "
           "object-src 'none'; base-uri 'none'; frame-ancestors 'none'");
  head.keep_alive(request.keep_alive());
  head.content_length(size);
  return head;
}

}  // namespace treeline::drive
