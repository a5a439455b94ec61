#include <sys/random.h>

#include <array>
#include <cerrno>
#include <charconv>
#include <string>
#include <system_error>

#include "drive/server.hpp"

namespace treeline::drive {
namespace {

bool is_loopback(std::string_view address) {
  return address == "127.0.0.1" || address == "::1" || address == "localhost";
}

/// Digits and dots with three of these, or what stands in brackets.
bool is_number_address(std::string_view host) {
  if (host.starts_with("[") && host.ends_with("]")) return true;
  int dots = 0;
  for (const char c : host) {
    if (c != '.' && (c < '0' || c > '9')) return false;
    dots += c == '.' ? 1 : 0;
  }
  return dots == 3;
}

}  // namespace

bool is_own_host(std::string_view host, std::string_view address, int port) {
  const std::size_t colon = host.rfind(':');
  if (colon == std::string_view::npos) return false;
  const std::string_view name = host.substr(0, colon);
  const std::string_view digits = host.substr(colon + 1);
  int named = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), named);
  if (error != std::errc{} || end != digits.data() + digits.size() || named != port) return false;
  if (name == "localhost") return true;
  if (is_loopback(address)) return name == "127.0.0.1" || name == "[::1]";
  return is_number_address(name);
}

bool is_own_origin(std::string_view origin, std::string_view host) {
  constexpr std::string_view kScheme = "http://";
  return origin.starts_with(kScheme) && origin.substr(kScheme.size()) == host;
}

bool is_own_fetch(const FetchMetadata& metadata, std::string_view path) {
  if (metadata.site.empty() || metadata.site == "same-origin" || metadata.site == "none") {
    return true;
  }
  return path == "/" && metadata.mode == "navigate";
}

bool is_same_secret(std::string_view a, std::string_view b) {
  if (a.size() != b.size()) return false;
  unsigned difference = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    difference |= static_cast<unsigned>(a[i] ^ b[i]);
  }
  return difference == 0;
}

std::string make_token() {
  std::array<unsigned char, 16> bytes{};
  if (getrandom(bytes.data(), bytes.size(), 0) != static_cast<ssize_t>(bytes.size())) {
    throw std::system_error(errno, std::generic_category(), "no random numbers");
  }
  std::string token;
  for (const unsigned char byte : bytes) {
    token += "0123456789abcdef"[byte >> 4];
    token += "0123456789abcdef"[byte & 15];
  }
  return token;
}

}  // namespace treeline::drive
