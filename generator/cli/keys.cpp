#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "cli/commands.hpp"
#include "description/scene_key_texts.hpp"
#include "terminal/exit_code.hpp"
#include "terminal/option_values.hpp"
#include "terminal/write_output.hpp"
#include "text/align_columns.hpp"

namespace treeline {
namespace {

struct KeysOptions {
  std::vector<std::string> names;  ///< empty: all
  bool json = false;
};

bool is_asked(const KeysOptions& options, const SceneKeyText& key) {
  const auto& names = options.names;
  return names.empty() || std::find(names.begin(), names.end(), key.name) != names.end();
}

std::string print_text(const SceneKeyText& key) {
  std::string text = wrap_labelled(std::string(key.name) + ": ", key.type, page_columns()) +
                     wrap_labelled("  Without it: ", key.fallback, page_columns()) +
                     wrap_labelled("  ", key.meaning, page_columns());
  if (key.page != nullptr) text += fmt::format("  More: docs/{}\n", key.page);
  return text + fmt::format("\n{}\n\n", key.example);
}

nlohmann::ordered_json print_json(const SceneKeyText& key) {
  return {{"name", key.name},
          {"type", key.type},
          {"default", key.fallback},
          {"meaning", key.meaning},
          {"example", key.example},
          {"page", key.page == nullptr ? nlohmann::ordered_json() : key.page}};
}

int run(const KeysOptions& options) {
  std::string text;
  auto list = nlohmann::ordered_json::array();
  for (const SceneKeyText& key : kSceneKeyTexts) {
    if (!is_asked(options, key)) continue;
    text += print_text(key);
    list.push_back(print_json(key));
  }
  return options.json ? write_output(list.dump(2) + "\n", OutputForm::json, kOk)
                      : write_output(text, OutputForm::text, kOk);
}

}  // namespace

void add_keys(CLI::App& app, int& exit_code) {
  auto options = std::make_shared<KeysOptions>();
  CLI::App* command =
      app.add_subcommand("keys", "List what a scene may say: type, default, meaning, example");
  std::vector<std::string> names;
  for (const SceneKeyText& key : kSceneKeyTexts) names.emplace_back(key.name);
  command->add_option("key", options->names, "Keys of a scene; all unless given")
      ->check(one_of(names));
  command->add_flag("--json", options->json, "The list as JSON");
  command->footer(
      "Examples:\n"
      "  treeline keys\n"
      "  treeline keys inputs torque_limits");
  command->callback([options, &exit_code] { exit_code = run(*options); });
}

}  // namespace treeline
