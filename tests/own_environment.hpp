#pragma once

#include <cstdlib>
#include <map>
#include <optional>
#include <string>

namespace treeline::test {

/// Environment variables of a test, which have their former values again at its end.
class OwnEnvironment {
 public:
  OwnEnvironment() = default;
  ~OwnEnvironment() {
    for (const auto& [name, value] : before_) assign(name, value);
  }
  OwnEnvironment(const OwnEnvironment&) = delete;
  OwnEnvironment& operator=(const OwnEnvironment&) = delete;

  /// Without a value: the variable is not set.
  void set(const std::string& name, const std::optional<std::string>& value) {
    const char* const present = std::getenv(name.c_str());
    before_.emplace(name, present == nullptr ? std::nullopt : std::optional<std::string>(present));
    assign(name, value);
  }

 private:
  static void assign(const std::string& name, const std::optional<std::string>& value) {
    if (value) {
      setenv(name.c_str(), value->c_str(), 1);
    } else {
      unsetenv(name.c_str());
    }
  }

  std::map<std::string, std::optional<std::string>> before_;
};

}  // namespace treeline::test
