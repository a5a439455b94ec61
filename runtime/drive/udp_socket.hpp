#pragma once
// What both sides of a robot over UDP need of the machine.

#include <arpa/inet.h>
#include <netinet/in.h>
#include <sys/socket.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <span>
#include <string>

namespace treeline::drive::udp {

/// The 16 hexadecimal digits of a robot's checksum as a number; others count as 0.
inline std::uint64_t checksum_number(const std::string& digits) {
  std::uint64_t number = 0;
  std::from_chars(digits.data(), digits.data() + digits.size(), number, 16);
  return number;
}

/// Reads HOST:PORT with a number as HOST.
inline bool read_address(const std::string& text, sockaddr_in& address) {
  const std::size_t colon = text.rfind(':');
  if (colon == std::string::npos) return false;
  const std::string host = text.substr(0, colon);
  const char* const begin = text.data() + colon + 1;
  const char* const end = text.data() + text.size();
  std::uint16_t port = 0;
  const auto [stopped, error] = std::from_chars(begin, end, port);
  address = {};
  address.sin_family = AF_INET;
  address.sin_port = htons(port);
  return error == std::errc{} && stopped == end &&
         inet_pton(AF_INET, host.c_str(), &address.sin_addr) == 1;
}

/// Below 0: there is none left.
inline int open_udp_socket() {
  return socket(AF_INET, SOCK_DGRAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0);
}

inline bool all_finite(std::span<const double> numbers) noexcept {
  return std::all_of(numbers.begin(), numbers.end(), [](double x) { return std::isfinite(x); });
}

}  // namespace treeline::drive::udp
