#include "cli/describe_usage_error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>

#include "text/suggest_name.hpp"

namespace treeline {
namespace {

std::vector<std::string> names_of_commands(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::App* command : app.get_subcommands({})) names.push_back(command->get_name());
  return names;
}

std::vector<std::string> names_of_options(const CLI::App& command) {
  std::vector<std::string> names;
  for (const CLI::Option* option : command.get_options()) {
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
  }
  return names;
}

/// The command that the line is about, else the program.
const CLI::App& find_command(const CLI::App& app) {
  const auto commands = app.get_subcommands();
  return commands.empty() ? app : *commands.front();
}

/// `treeline generate`.
std::string full_name(const CLI::App& app, const CLI::App& command) {
  return &command == &app ? app.get_name() : app.get_name() + " " + command.get_name();
}

/// `treeline generate urdf [scene] [options]`.
std::string usage_of(const CLI::App& app, const CLI::App& command) {
  std::string usage = full_name(app, command);
  for (const CLI::Option* option : command.get_options()) {
    if (!option->get_positional()) continue;
    const std::string name = option->get_name(true);
    usage += option->get_required() ? " " + name : fmt::format(" [{}]", name);
  }
  return fmt::format("write {} [options]; {} --help lists the options", usage,
                     full_name(app, command));
}

std::string replaced(std::string text, const std::string& old, const std::string& by) {
  if (const auto at = text.find(old); at != std::string::npos) text.replace(at, old.size(), by);
  return text;
}

Diagnostic describe_rest(const CLI::App& app, const CLI::App& command, const std::string& given) {
  Diagnostic diagnostic{Severity::error, full_name(app, command), 0, "", "", ""};
  if (given.starts_with('-')) {
    const std::string option = given.substr(0, given.find('='));
    diagnostic.fault = fmt::format("there is no option {}", option);
    diagnostic.remedy = suggest_name(option, names_of_options(command), "the options are");
  } else {
    diagnostic.fault = fmt::format("\"{}\" is one argument too many", given);
    diagnostic.remedy = usage_of(app, command);
  }
  return diagnostic;
}

/// The parser's own text, where it is not from this program, in plainer words.
std::string plain_words(const CLI::ParseError& error) {
  std::string text = error.what();
  const std::string& kind = error.get_name();
  if (kind == "RequiredError") {
    return replaced(std::move(text), " is required", " is missing");
  }
  if (kind == "ExcludesError") return replaced(std::move(text), " excludes ", " does not go with ");
  if (kind == "RequiresError") return replaced(std::move(text), " requires ", " needs ");
  if (kind == "ArgumentMismatch" && text.find("missing") != std::string::npos) {
    return text.substr(0, text.find(':')) + ": its value is missing";
  }
  constexpr std::string_view kTooMany = ": At Most 1 required but received ";
  if (const auto at = text.find(kTooMany); at != std::string::npos) {
    return fmt::format("{}: it is given {} times, and once is enough", text.substr(0, at),
                       text.substr(at + kTooMany.size()));
  }
  return replaced(std::move(text), "Could not convert: ", "this cannot be read: ");
}

}  // namespace

void reject_unknown_command(const CLI::App& app, const std::vector<std::string>& arguments,
                            Diagnostics& diagnostics) {
  const std::vector<std::string> commands = names_of_commands(app);
  const auto add = [&](std::string fault, std::string remedy) {
    diagnostics.add({Severity::error, app.get_name(), 0, "", std::move(fault), std::move(remedy)});
  };
  if (arguments.empty()) {
    add("no command is given", fmt::format("the commands are {}; {} help says what they do",
                                           list_names(commands), app.get_name()));
    return;
  }
  const std::string& first = arguments.front();
  if (first.starts_with('-') && first.size() > 1) return;
  if (std::find(commands.begin(), commands.end(), first) != commands.end()) return;
  add(fmt::format("there is no command \"{}\"", first),
      suggest_name(first, commands, "the commands are"));
}

Diagnostic describe_usage_error(const CLI::App& app, const CLI::ParseError& error) {
  const CLI::App& command = find_command(app);
  // An option that is not known hides behind whatever is missing in its stead.
  const std::vector<std::string> rest = app.remaining(true);
  const auto option = std::find_if(rest.begin(), rest.end(),
                                   [](const std::string& each) { return each.starts_with('-'); });
  if (option != rest.end()) return describe_rest(app, command, *option);
  if (!rest.empty()) return describe_rest(app, command, rest.front());
  const std::string text = plain_words(error);
  const auto line = text.find('\n');  // a check's own fault and remedy, see option_values.hpp
  const bool own = line != std::string::npos;
  return {Severity::error,
          full_name(app, command),
          0,
          "",
          text.substr(0, line),
          own ? text.substr(line + 1) : usage_of(app, command)};
}

}  // namespace treeline
