#include "terminal/print_diagnostics.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <cstdlib>
#include <map>
#include <nlohmann/json.hpp>
#include <string_view>

#include "terminal/option_values.hpp"
#include "terminal/progress_line.hpp"
#include "terminal/write_output.hpp"
#include "text/json_text.hpp"
#include "text/suggest_name.hpp"

namespace treeline {
namespace {

struct KindWords {
  Minor minor;
  const char* one;
  const char* many;
};
constexpr std::array kKinds = {
    KindWords{Minor::attribute, "unknown attribute", "unknown attributes"},
    KindWords{Minor::element, "unknown element", "unknown elements"},
    KindWords{Minor::text, "text between elements", "texts between elements"},
    KindWords{Minor::form, "oddity of form", "oddities of form"}};

constexpr std::size_t kMostNamed = 4;

/// Faults of one kind in a file.
struct Counted {
  int count = 0;
  std::vector<std::string> names;  ///< of elements or attributes, each once
};
using Counts = std::map<Minor, Counted>;

/// `<name>`, or "name", that a fault begins with.
std::string name_in(const std::string& fault) {
  const std::size_t begin = fault.find_first_of("<\"");
  if (begin == fault.npos) return {};
  const std::size_t end = fault.find_first_of(">\"", begin + 1);
  return end == fault.npos ? std::string() : fault.substr(begin, end + 1 - begin);
}

void count(const Diagnostic& each, Counts& counts) {
  Counted& counted = counts[each.minor];
  counted.count += each.times;
  if (each.minor != Minor::attribute && each.minor != Minor::element) return;
  const std::string name = name_in(each.fault);
  if (name.empty() || std::ranges::find(counted.names, name) != counted.names.end()) return;
  counted.names.push_back(name);
}

std::string print_counts(const Counts& counts) {
  std::string text;
  for (const KindWords& kind : kKinds) {
    const auto found = counts.find(kind.minor);
    if (found == counts.end()) continue;
    const auto& [count, names] = found->second;
    text +=
        fmt::format("{}{} {}", text.empty() ? "" : ", ", count, count == 1 ? kind.one : kind.many);
    if (!names.empty()) text += fmt::format(" ({})", list_first(names, kMostNamed));
  }
  return text;
}

std::vector<Diagnostic> summarise(const std::vector<Diagnostic>& minor) {
  std::vector<std::string> files;
  std::map<std::string, Counts> counts;
  for (const Diagnostic& each : minor) {
    if (!counts.contains(each.file)) files.push_back(each.file);
    count(each, counts[each.file]);
  }
  std::vector<Diagnostic> lines;
  const auto add = [&lines](const std::string& file, const std::string& fault) {
    lines.push_back({Severity::warning, file, 0, "", fault + "; --warnings all lists them", ""});
  };
  for (const std::string& file : files) {
    const std::string idle = print_counts(counts[file]);
    if (!idle.empty()) add(file, "without effect here: " + idle);
    const int limits = counts[file][Minor::limit].count;
    if (limits == 1) add(file, "1 limit is missing and counts as none");
    if (limits > 1) add(file, fmt::format("{} limits are missing and count as none", limits));
  }
  return lines;
}

bool wants_colour() {
  const char* const no_colour = std::getenv("NO_COLOR");
  const char* const terminal = std::getenv("TERM");
  const bool refused = no_colour != nullptr && *no_colour != '\0';
  const bool dumb = terminal != nullptr && std::string_view(terminal) == "dumb";
  return is_watched() && !refused && !dumb;
}

/// The severity as terminals show it: cyan, magenta or red, bold.
std::string coloured(Severity severity) {
  const int colour = severity == Severity::note ? 36 : severity == Severity::warning ? 35 : 31;
  return fmt::format("\033[1;{}m{}:\033[0m ", colour, severity_name(severity));
}

/// Whether a program reads the messages.
bool wants_json() {
  const char* const form = std::getenv("TREELINE_MESSAGES");
  return form != nullptr && std::string_view(form) == "json";
}

/// Each diagnostic as a line of JSON, with the text that people are shown.
std::string print_diagnostics_json(const std::vector<Diagnostic>& list) {
  std::string lines;
  for (const Diagnostic& each : list) {
    const nlohmann::ordered_json json = {{"severity", severity_name(each.severity)},
                                         {"file", each.file},
                                         {"line", each.line},
                                         {"element", each.element},
                                         {"fault", each.fault},
                                         {"remedy", each.remedy},
                                         {"text", to_string(each)}};
    lines += json_line(json) + "\n";
  }
  return lines;
}

}  // namespace

void add_warnings_option(CLI::App& command, Warnings& warnings) {
  command
      .add_option("--warnings", warnings,
                  "all; summary: formatting problems in one line a file; none: errors alone")
      ->transform(one_of<Warnings>(
          {{"all", Warnings::all}, {"summary", Warnings::summary}, {"none", Warnings::none}}));
}

std::vector<Diagnostic> select_diagnostics(const Diagnostics& diagnostics, Warnings warnings) {
  std::vector<Diagnostic> selected;
  std::vector<Diagnostic> minor;
  for (const Diagnostic& each : diagnostics.list()) {
    const bool is_error = each.severity == Severity::error;
    if (warnings == Warnings::none && !is_error) continue;
    const bool counts = warnings == Warnings::summary && each.minor != Minor::none && !is_error;
    (counts ? minor : selected).push_back(each);
  }
  std::stable_sort(selected.begin(), selected.end(), [](const Diagnostic& a, const Diagnostic& b) {
    return a.severity < b.severity;
  });
  const auto first_warning =
      std::find_if(selected.begin(), selected.end(),
                   [](const Diagnostic& each) { return each.severity != Severity::note; });
  const std::vector<Diagnostic> lines = summarise(minor);
  selected.insert(first_warning, lines.begin(), lines.end());
  return selected;
}

std::string print_diagnostics_text(const std::vector<Diagnostic>& list, bool colour) {
  std::string text;
  for (std::size_t i = 0; i < list.size(); ++i) {
    const Diagnostic& each = list[i];
    text += place_of(each);
    text += colour ? coloured(each.severity) : fmt::format("{}: ", severity_name(each.severity));
    text += fault_of(each);
    const bool again = i + 1 < list.size() && list[i + 1].remedy == each.remedy &&
                       list[i + 1].severity == each.severity;
    if (!again) text += remedy_of(each);
    text += '\n';
  }
  return text;
}

void print_diagnostics(const Diagnostics& diagnostics, Warnings warnings) {
  const std::vector<Diagnostic> selected = select_diagnostics(diagnostics, warnings);
  print_message(wants_json() ? print_diagnostics_json(selected)
                             : print_diagnostics_text(selected, wants_colour()));
}

}  // namespace treeline
