#include "description/scene_element.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "description/read_number.hpp"
#include "description/suggestions.hpp"
#include "text/printable.hpp"
#include "text/suggest_name.hpp"

namespace treeline {
namespace {

constexpr int kMostSceneReports = 1000;
// As many as a robot may have links.
constexpr std::size_t kMostItems = 4096;

/// The first characters, and what says that there are more.
std::string shortened_scalar(const std::string& text) {
  constexpr std::size_t kMost = 60;
  std::size_t end = std::min(text.size(), kMost);
  while (end < text.size() && (static_cast<unsigned char>(text[end]) & 0xC0U) == 0x80U) --end;
  return text.size() > end ? text.substr(0, end) + "..." : text;
}

}  // namespace

SceneElement::SceneElement(const YAML::Node& node, std::string path, SceneReading& reading,
                           int alias_line)
    : node_(node), path_(std::move(path)), alias_line_(alias_line), reading_(&reading) {
  const auto alias = reading.aliases.find(path_);
  if (alias_line_ == 0 && alias != reading.aliases.end()) alias_line_ = alias->second;
  line_ = alias_line_ > 0 ? alias_line_ : node_.Mark().line + 1;
}

void SceneElement::report(Severity severity, std::string fault, std::string remedy) const {
  const bool first_error = severity == Severity::error && !reading_->failed;
  reading_->failed = reading_->failed || severity == Severity::error;
  ++reading_->reports;
  if (reading_->reports > kMostSceneReports + 1 && !first_error) return;
  if (reading_->reports > kMostSceneReports && !first_error) {
    fault = "there are more faults, which are not listed";
    remedy = "mend those above first";
  }
  reading_->diagnostics.add(
      {severity, reading_->file, line_, path_, std::move(fault), std::move(remedy)});
}

void SceneElement::error(std::string fault, std::string remedy) const {
  report(Severity::error, std::move(fault), std::move(remedy));
}

void SceneElement::warn(std::string fault, std::string remedy) const {
  report(Severity::warning, std::move(fault), std::move(remedy));
}

void SceneElement::note(std::string fact, std::string remedy) const {
  report(Severity::note, std::move(fact), std::move(remedy));
}

std::string SceneElement::kind() const {
  if (node_.IsMap()) return "a map";
  if (node_.IsSequence()) return "a list";
  if (node_.IsScalar()) return fmt::format("\"{}\"", shortened_scalar(node_.Scalar()));
  return "empty";
}

bool SceneElement::has_few() const {
  // Aliases let a short text list the same faults millions of times.
  if (reading_->reports > kMostSceneReports) return false;
  if (node_.size() <= kMostItems) return true;
  error(fmt::format("there are {} entries, more than {}", node_.size(), kMostItems),
        "list fewer: no robot that can be generated has as many links");
  return false;
}

SceneElement SceneElement::inside(const YAML::Node& node, const std::string& step) const {
  return {node, path_.empty() ? step : path_ + "/" + step, *reading_, alias_line_};
}

SceneElement SceneElement::item(std::size_t i) const {
  return {node_[i], fmt::format("{}[{}]", path_, i), *reading_, alias_line_};
}

SceneElement SceneElement::at(const std::string& key) const {
  const YAML::Node value = node_.IsMap() ? node_[key] : YAML::Node(YAML::NodeType::Undefined);
  return value.IsDefined() ? inside(value, key) : *this;
}

bool SceneElement::is(std::string_view word) const {
  return node_.IsScalar() && node_.Scalar() == word;
}

std::vector<SceneElement::Entry> SceneElement::entries(const std::string& remedy) const {
  std::vector<Entry> entries;
  if (!node_.IsMap()) {
    error(fmt::format("a map is expected here, not {}", kind()), remedy);
    return entries;
  }
  if (!has_few()) return entries;
  std::set<std::string> seen;
  for (const auto& pair : node_) {
    if (!pair.first.IsScalar()) {
      inside(pair.first, "?").error("a key must be a plain word", "write key: value");
      continue;
    }
    const std::string key = pair.first.Scalar();
    if (!seen.insert(key).second) {
      SceneElement repeated = inside(pair.first, key);
      repeated.line_ = pair.first.Mark().line + 1;
      repeated.error("the key is given twice", "keep one of the two");
      continue;
    }
    entries.emplace_back(key, inside(pair.second, key));
    // The place of an empty value is that of whatever follows it.
    if (pair.second.IsNull() && entries.back().second.alias_line_ == 0) {
      entries.back().second.line_ = pair.first.Mark().line + 1;
    }
  }
  return entries;
}

SceneFields SceneElement::fields(const std::vector<std::string>& known) const {
  SceneFields fields;
  const std::string remedy =
      fmt::format("write key: value for some of the keys {}", list_names(known));
  for (const auto& [key, value] : entries(remedy)) {
    if (std::find(known.begin(), known.end(), key) != known.end()) {
      fields.emplace(key, value);
    } else {
      value.error(fmt::format("the key \"{}\" is unknown{}", key, note_odd_character(key)),
                  suggest_key(key, known));
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
  if (!has_few()) return items;
  for (std::size_t i = 0; i < node_.size(); ++i) {
    items.push_back(item(i));
  }
  return items;
}

std::optional<std::string> SceneElement::text() const {
  if (node_.IsScalar() && !node_.Scalar().empty()) return node_.Scalar();
  error(fmt::format("a name is expected here, not {}", kind()), "write one word");
  return std::nullopt;
}

std::optional<std::size_t> SceneElement::choice(const std::vector<std::string>& choices) const {
  if (!node_.IsScalar()) {
    error(fmt::format("one word is expected here, not {}", kind()),
          fmt::format("the choices are {}", list_names(choices)));
    return std::nullopt;
  }
  const auto given = text();
  if (!given) return std::nullopt;
  for (std::size_t i = 0; i < choices.size(); ++i) {
    if (*given == choices[i]) return i;
  }
  const bool is_number = read_number(*given).has_value();  // and no slip for another
  error(fmt::format("\"{}\" is not known here", *given),
        is_number ? fmt::format("the choices are {}", list_names(choices))
                  : suggest_choice(*given, choices));
  return std::nullopt;
}

std::optional<double> SceneElement::number(bool angle) const {
  const bool quoted = node_.Tag() == "!";
  const auto value = node_.IsScalar() && !quoted ? read_number(node_.Scalar()) : std::nullopt;
  if (value && std::isfinite(*value)) {
    if (!is_too_large(*value, angle)) return value;
    error(fmt::format("{} is too large to compute with", *value),
          angle ? fmt::format("give an angle of at most {} rad", kLargestAngle)
                : fmt::format("give a number of at most {} in SI units", kLargestNumber));
    return std::nullopt;
  }
  error(fmt::format("a finite number is expected here, not {}{}", kind(),
                    node_.IsScalar() ? note_odd_character(node_.Scalar()) : ""),
        "write one decimal number with a point and without quotes, such as 0.25");
  return std::nullopt;
}

std::optional<std::array<double, 3>> SceneElement::three_numbers(bool angles) const {
  if (!node_.IsSequence() || node_.size() != 3) {
    const std::string found = node_.IsSequence() ? fmt::format("{}", node_.size()) : kind();
    error(fmt::format("a list of three numbers is expected here, not {}", found),
          "write [x, y, z]");
    return std::nullopt;
  }
  std::array<double, 3> values{};
  for (std::size_t i = 0; i < 3; ++i) {
    const auto value = item(i).number(angles);
    if (!value) return std::nullopt;
    values[i] = *value;
  }
  return values;
}

}  // namespace treeline
