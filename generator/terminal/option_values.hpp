#pragma once

#include <CLI/CLI.hpp>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "text/diagnostic.hpp"

namespace treeline {

/// One of these words: anything else is a usage error that names the near one, or all. The text of
/// a check is what is wrong and, behind a line break, what to do about it.
CLI::Validator one_of(const std::vector<std::string>& words);

/// A number from `low` to `high`.
CLI::Validator between(double low, double high);

/// A whole number from `low` to `high`.
CLI::Validator whole_between(std::int64_t low, std::int64_t high);

/// A finite number.
CLI::Validator any_number();

/// A path of a short option, which is written as `-o PATH`: of `-o=PATH` the sign would become part
/// of the name.
CLI::Validator no_equals_sign();

/// A path to write that is not named as a robot or a scene is: where it is forgotten, the file
/// behind the option is one that should be read.
CLI::Validator no_input_file();

/// Whether an option was given as many numbers as the robot has, or none; else an error that names
/// the option.
bool has_size(const char* option, const std::vector<double>& given, int size,
              Diagnostics& diagnostics);

/// A word that stands for a value of an enumeration; for `transform`.
template <class Value>
CLI::Validator one_of(const std::vector<std::pair<std::string, Value>>& values) {
  std::vector<std::string> words;
  for (const auto& [word, value] : values) words.push_back(word);
  const CLI::Validator check = one_of(words);
  return CLI::Validator(
      [check, values](std::string& given) {
        std::string fault = check(given);
        for (const auto& [word, value] : values) {
          if (!fault.empty() || word != given) continue;
          given = std::to_string(static_cast<int>(value));
          break;
        }
        return fault;
      },
      "");
}

}  // namespace treeline
