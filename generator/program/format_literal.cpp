#include "program/format_literal.hpp"

#include <array>
#include <charconv>

namespace treeline {
namespace {

template <class Real>
std::string shortest(Real value) {
  std::array<char, 64> buffer{};
  const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value).ptr;
  std::string text(buffer.data(), end);
  if (text.find_first_of(".en") == std::string::npos) {  // n: for inf and nan, which stay
    text += ".0";
  }
  return text;
}

}  // namespace

std::string format_literal(double value) {
  return shortest(value);
}
std::string format_literal(float value) {
  return shortest(value) + "f";
}

}  // namespace treeline
