#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace CLI {
class App;
}  // namespace CLI

namespace treeline::experiments {

/// Bounds that an option's value must keep; both belong to it.
struct Range {
  double low;
  double high;
};

/// The options of an experiment's program. CLI11 is behind it, which takes seconds to compile. What
/// an option sets must live until `parse`; what it holds before is the default, which --help shows.
class CommandLine {
 public:
  /// `description` heads the text of --help.
  explicit CommandLine(const std::string& description);
  ~CommandLine();
  CommandLine(const CommandLine&) = delete;
  CommandLine& operator=(const CommandLine&) = delete;

  void add_text(const std::string& name, std::string& value, const std::string& help);
  /// A folder that exists.
  void add_folder(const std::string& name, std::string& value, const std::string& help);
  void add_choice(const std::string& name, std::string& value,
                  const std::vector<std::string>& choices, const std::string& help);
  void add_number(const std::string& name, double& value, Range range, const std::string& help);
  void add_number(const std::string& name, std::optional<double>& value, Range range,
                  const std::string& help);
  /// From 1 to `most`.
  void add_count(const std::string& name, int& value, int most, const std::string& help);
  void add_flag(const std::string& name, bool& value, const std::string& help);

  /// Sets the values. Returns nothing if the program is to go on, else its exit status: 0 after
  /// --help, 2 after options that are wrong, with the reason on stderr.
  std::optional<int> parse(int argc, char** argv);

 private:
  std::unique_ptr<CLI::App> app_;
};

}  // namespace treeline::experiments
