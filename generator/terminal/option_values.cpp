#include "terminal/option_values.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>

#include "description/read_number.hpp"
#include "text/suggest_name.hpp"

namespace treeline {

CLI::Validator one_of(const std::vector<std::string>& words) {
  return CLI::Validator(
      [words](std::string& given) {
        if (std::find(words.begin(), words.end(), given) != words.end()) return std::string();
        return fmt::format("\"{}\" is not known here\n{}", given, suggest_choice(given, words));
      },
      fmt::format("{{{}}}", fmt::join(words, ",")));
}

CLI::Validator between(double low, double high) {
  const std::string range = fmt::format("a number from {:g} to {:g}", low, high);
  return CLI::Validator(
      [low, high, range](std::string& given) {
        const auto value = read_number(given);
        if (value && *value >= low && *value <= high) return std::string();
        return fmt::format("\"{}\" is not {}\nwrite {}", given, range, range);
      },
      fmt::format("{:g}..{:g}", low, high));
}

CLI::Validator whole_between(std::int64_t low, std::int64_t high) {
  const std::string range = fmt::format("a whole number from {} to {}", low, high);
  return CLI::Validator(
      [low, high, range](std::string& given) {
        std::int64_t value = 0;
        const char* const end = given.data() + given.size();
        const auto [last, error] = std::from_chars(given.data(), end, value);
        if (error == std::errc{} && last == end && value >= low && value <= high) {
          return std::string();
        }
        return fmt::format("\"{}\" is not {}\nwrite {}", given, range, range);
      },
      high == std::numeric_limits<std::int64_t>::max() ? "" : fmt::format("{}..{}", low, high));
}

CLI::Validator any_number() {
  return CLI::Validator(
      [](std::string& given) {
        const auto value = read_number(given);
        if (value && std::isfinite(*value)) return std::string();
        return fmt::format(
            "\"{}\" is not a number\nwrite decimal numbers with a point, such as 0.25", given);
      },
      "");
}

CLI::Validator no_equals_sign() {
  return CLI::Validator(
      [](std::string& given) {
        if (!given.starts_with("=")) return std::string();
        return fmt::format(
            "\"{}\" begins with a sign that a short option does not have\n"
            "write -o {}, or --output{}",
            given, given.substr(1), given);
      },
      "");
}

CLI::Validator no_input_file() {
  return CLI::Validator(
      [](std::string& given) {
        constexpr std::array kOfInputs = {".urdf", ".xacro", ".sdf", ".xml", ".yaml", ".yml"};
        const bool is_input = std::any_of(kOfInputs.begin(), kOfInputs.end(),
                                          [&](const char* end) { return given.ends_with(end); });
        if (!is_input) return std::string();
        return fmt::format(
            "\"{}\" is the name of a robot or a scene, and would be written over\n"
            "name the file to write behind this option, and that one by itself",
            given);
      },
      "");
}

bool has_size(const char* option, const std::vector<double>& given, int size,
              Diagnostics& diagnostics) {
  if (given.empty() || static_cast<int>(given.size()) == size) return true;
  diagnostics.add({Severity::error, "", 0, option,
                   fmt::format("{} numbers are given, the robot has {}", given.size(), size),
                   "`treeline inspect` lists the joints in their order."});
  return false;
}

}  // namespace treeline
