#include "command_line/command_line.hpp"

#include <CLI/CLI.hpp>

namespace treeline::experiments {

CommandLine::CommandLine(const std::string& description)
    : app_(std::make_unique<CLI::App>(description)) {}

CommandLine::~CommandLine() = default;

void CommandLine::add_text(const std::string& name, std::string& value, const std::string& help) {
  app_->add_option(name, value, help)->capture_default_str();
}

void CommandLine::add_folder(const std::string& name, std::string& value, const std::string& help) {
  app_->add_option(name, value, help)->check(CLI::ExistingDirectory);
}

void CommandLine::add_choice(const std::string& name, std::string& value,
                             const std::vector<std::string>& choices, const std::string& help) {
  app_->add_option(name, value, help)->check(CLI::IsMember(choices))->capture_default_str();
}

void CommandLine::add_number(const std::string& name, double& value, Range range,
                             const std::string& help) {
  app_->add_option(name, value, help)
      ->check(CLI::Range(range.low, range.high))
      ->capture_default_str();
}

void CommandLine::add_number(const std::string& name, std::optional<double>& value, Range range,
                             const std::string& help) {
  app_->add_option(name, value, help)->check(CLI::Range(range.low, range.high));
}

void CommandLine::add_count(const std::string& name, int& value, int most,
                            const std::string& help) {
  app_->add_option(name, value, help)->check(CLI::Range(1, most))->capture_default_str();
}

void CommandLine::add_flag(const std::string& name, bool& value, const std::string& help) {
  app_->add_flag(name, value, help);
}

std::optional<int> CommandLine::parse(int argc, char** argv) {
  try {
    app_->parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app_->exit(error) == 0 ? 0 : 2;
  }
  return std::nullopt;
}

}  // namespace treeline::experiments
