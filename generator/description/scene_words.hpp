#pragma once

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include "description/scene.hpp"

namespace treeline {

/// The words that scenes, and options in their place, have for the values of an enumeration, in
/// their order.
template <class Value>
const std::vector<std::string>& words_of();

template <>
inline const std::vector<std::string>& words_of<Base>() {
  static const std::vector<std::string> words = {"fixed", "floating"};
  return words;
}
template <>
inline const std::vector<std::string>& words_of<Real>() {
  static const std::vector<std::string> words = {"float", "double"};
  return words;
}
template <>
inline const std::vector<std::string>& words_of<Language>() {
  static const std::vector<std::string> words = {"c++", "c", "opencl"};
  return words;
}
template <>
inline const std::vector<std::string>& words_of<Profile>() {
  static const std::vector<std::string> words = {"plain", "misra"};
  return words;
}
template <>
inline const std::vector<std::string>& words_of<Optimize>() {
  static const std::vector<std::string> words = {"speed", "size"};
  return words;
}
template <>
inline const std::vector<std::string>& words_of<Accuracy>() {
  static const std::vector<std::string> words = {"best", "balanced", "fastest"};
  return words;
}

template <>
inline const std::vector<std::string>& words_of<Sines>() {
  static const std::vector<std::string> words = {"computed", "given"};
  return words;
}
template <>
inline const std::vector<std::string>& words_of<SingularTasks>() {
  static const std::vector<std::string> words = {"smooth", "exact", "early"};
  return words;
}

template <class Value>
const std::string& word_of(Value value) {
  return words_of<Value>()[static_cast<std::size_t>(value)];
}

/// The value of a word; nothing for a word that it does not have.
template <class Value>
std::optional<Value> value_of_word(const std::string& word) {
  const auto& words = words_of<Value>();
  const auto found = std::find(words.begin(), words.end(), word);
  if (found == words.end()) return std::nullopt;
  return static_cast<Value>(found - words.begin());
}

}  // namespace treeline
