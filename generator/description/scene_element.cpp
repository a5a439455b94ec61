#include "description/scene_element.hpp"

#include <fmt/format.h>

#include <cmath>
#include <set>

#include "description/read_number.hpp"
#include "description/suggest_name.hpp"

namespace treeline {

void SceneElement::report(Severity severity, std::string fault, std::string remedy) const {
  reading_->failed = reading_->failed || severity == Severity::error;
  reading_->diagnostics.add(
      {severity, reading_->file, line_, path_, std::move(fault), std::move(remedy)});
}

void SceneElement::error(std::string fault, std::string remedy) const {
  report(Severity::error, std::move(fault), std::move(remedy));
}

void SceneElement::warn(std::string fault, std::string remedy) const {
  report(Severity::warning, std::move(fault), std::move(remedy));
}

std::string SceneElement::kind() const {
  if (node_.IsMap()) return "a map";
  if (node_.IsSequence()) return "a list";
  if (node_.IsScalar()) return fmt::format("\"{}\"", node_.Scalar());
  return "empty";
}

SceneElement SceneElement::inside(const YAML::Node& node, const std::string& step) const {
  return {node, path_.empty() ? step : path_ + "/" + step, *reading_};
}

std::vector<SceneElement::Entry> SceneElement::entries() const {
  std::vector<Entry> entries;
  if (!node_.IsMap()) {
    error(fmt::format("a map is expected here, not {}", kind()),
          "write lines of the form key: value");
    return entries;
  }
  std::set<std::string> seen;
  for (const auto& pair : node_) {
    if (!pair.first.IsScalar()) {
      inside(pair.first, "?").error("a key must be a plain word", "write key: value");
      continue;
    }
    const std::string key = pair.first.Scalar();
    if (!seen.insert(key).second) {
      inside(pair.first, key).error("the key is given twice", "keep one of the two");
      continue;
    }
    entries.emplace_back(key, inside(pair.second, key));
    // The place of an empty value is that of whatever follows it.
    if (pair.second.IsNull()) entries.back().second.line_ = pair.first.Mark().line + 1;
  }
  return entries;
}

std::map<std::string, SceneElement> SceneElement::fields(
    const std::vector<std::string>& known) const {
  std::map<std::string, SceneElement> fields;
  for (const auto& [key, value] : entries()) {
    if (std::find(known.begin(), known.end(), key) != known.end()) {
      fields.emplace(key, value);
    } else {
      value.error(fmt::format("the key \"{}\" is unknown", key),
                  suggest_name(key, known, "the keys here are"));
    }
  }
  return fields;
}

std::vector<SceneElement> SceneElement::items() const {
  std::vector<SceneElement> items;
  if (!node_.IsSequence()) {
    error(fmt::format("a list is expected here, not {}", kind()),
          "write [a, b], or a line \"- item\" for each");
    return items;
  }
  for (std::size_t i = 0; i < node_.size(); ++i) {
    items.push_back({node_[i], fmt::format("{}[{}]", path_, i), *reading_});
  }
  return items;
}

std::optional<std::string> SceneElement::text() const {
  if (node_.IsScalar() && !node_.Scalar().empty()) return node_.Scalar();
  error(fmt::format("a name is expected here, not {}", kind()), "write one word");
  return std::nullopt;
}

std::optional<std::size_t> SceneElement::choice(const std::vector<std::string>& choices) const {
  const auto given = text();
  if (!given) return std::nullopt;
  for (std::size_t i = 0; i < choices.size(); ++i) {
    if (*given == choices[i]) return i;
  }
  error(fmt::format("\"{}\" is not known here", *given),
        suggest_name(*given, choices, "the choices are"));
  return std::nullopt;
}

std::optional<double> SceneElement::number() const {
  const bool quoted = node_.Tag() == "!";
  const auto value = node_.IsScalar() && !quoted ? read_number(node_.Scalar()) : std::nullopt;
  if (value && std::isfinite(*value)) return value;
  error(fmt::format("a finite number is expected here, not {}", kind()),
        "write one decimal number with a point and without quotes, such as 0.25");
  return std::nullopt;
}

std::optional<std::array<double, 3>> SceneElement::three_numbers() const {
  if (!node_.IsSequence() || node_.size() != 3) {
    const std::string found = node_.IsSequence() ? fmt::format("{}", node_.size()) : kind();
    error(fmt::format("a list of three numbers is expected here, not {}", found),
          "write [x, y, z]");
    return std::nullopt;
  }
  std::array<double, 3> values{};
  for (std::size_t i = 0; i < 3; ++i) {
    const auto value = SceneElement(node_[i], fmt::format("{}[{}]", path_, i), *reading_).number();
    if (!value) return std::nullopt;
    values[i] = *value;
  }
  return values;
}

}  // namespace treeline
