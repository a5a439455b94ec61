#include "report/decades.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace treeline::report {

double Decades::at(double value) const {
  return (std::log10(value) - first) / static_cast<double>(last - first);
}

Decades decades_of(const std::vector<double>& values, double room) {
  if (values.empty()) return {0, 1};
  const auto [least, most] = std::minmax_element(values.begin(), values.end());
  const int first = static_cast<int>(std::floor(std::log10(*least) - room - 0.05));
  const int last = static_cast<int>(std::ceil(std::log10(*most) + 0.05));
  return {first, std::max(last, first + 1)};
}

std::string time_name(int decade) {
  constexpr std::array kNames = {"1 ns",  "10 ns",  "100 ns", "1 µs",
                                 "10 µs", "100 µs", "1 ms",   "10 ms"};
  if (decade < 0 || decade >= static_cast<int>(kNames.size())) {
    return fmt::format("1e{} ns", decade);
  }
  return kNames[static_cast<std::size_t>(decade)];
}

}  // namespace treeline::report
