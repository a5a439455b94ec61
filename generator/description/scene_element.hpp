#pragma once

#include <yaml-cpp/yaml.h>

#include <array>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "text/diagnostic.hpp"

namespace treeline {

/// One reading of a scene: where faults go.
struct SceneReading {
  std::string file;
  Diagnostics& diagnostics;
  std::map<std::string, int> aliases = {};  ///< lines of `alias_lines`
  bool failed = false;
  int reports = 0;  ///< beyond a thousand, the next one says so and the rest are not listed
};

class SceneElement;

/// Values of a map in the scene, by key.
using SceneFields = std::map<std::string, SceneElement>;

/// A value in the scene's YAML. Readers report what is malformed as an error, with line and path,
/// and go on with nothing.
class SceneElement {
 public:
  using Entry = std::pair<std::string, SceneElement>;

  SceneElement(const YAML::Node& node, std::string path, SceneReading& reading)
      : SceneElement(node, std::move(path), reading, 0) {}

  void error(std::string fault, std::string remedy) const;
  void warn(std::string fault, std::string remedy) const;
  void note(std::string fact, std::string remedy) const;

  /// The value under `key`; this where there is none.
  [[nodiscard]] SceneElement at(const std::string& key) const;
  /// Whether this is that plain word.
  [[nodiscard]] bool is(std::string_view word) const;
  [[nodiscard]] bool is_list() const { return node_.IsSequence(); }
  [[nodiscard]] bool is_map() const { return node_.IsMap(); }
  [[nodiscard]] int line() const { return line_; }
  /// Entries of a map in the file's order; an error for no map, with `remedy`, and for a key given
  /// twice.
  [[nodiscard]] std::vector<Entry> entries(
      const std::string& remedy = "write lines of the form key: value") const;
  /// Entries of a map whose keys are known; an error, with a suggestion, for any other key.
  [[nodiscard]] SceneFields fields(const std::vector<std::string>& known) const;
  /// Items of a list of at most 4096; an error for anything else.
  [[nodiscard]] std::vector<SceneElement> items() const;
  /// A text that is not empty.
  [[nodiscard]] std::optional<std::string> text() const;
  /// Index into `choices`; an error with a suggestion for any other text.
  [[nodiscard]] std::optional<std::size_t> choice(const std::vector<std::string>& choices) const;
  /// A finite number, not in quotes, not too large to compute with (see `is_too_large`).
  [[nodiscard]] std::optional<double> number(bool angle = false) const;
  [[nodiscard]] std::optional<std::array<double, 3>> three_numbers(bool angles = false) const;

 private:
  SceneElement(const YAML::Node& node, std::string path, SceneReading& reading, int alias_line);
  [[nodiscard]] SceneElement inside(const YAML::Node& node, const std::string& step) const;
  [[nodiscard]] SceneElement item(std::size_t i) const;
  void report(Severity severity, std::string fault, std::string remedy) const;
  [[nodiscard]] std::string kind() const;
  [[nodiscard]] bool has_few() const;

  YAML::Node node_;
  std::string path_;
  int alias_line_;  ///< of the alias within which this is; 0: none
  int line_ = 0;
  SceneReading* reading_;
};

}  // namespace treeline
