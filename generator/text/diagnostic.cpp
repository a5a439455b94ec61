#include "text/diagnostic.hpp"

#include <fmt/format.h>

#include "text/printable.hpp"

namespace treeline {
namespace {

/// Lines behind the first are indented, so that no text of a file looks like a message of its own.
std::string indented(const std::string& text) {
  std::string lines = printable_lines(text);
  for (std::size_t at = lines.find('\n'); at != std::string::npos; at = lines.find('\n', at + 1)) {
    if (lines.compare(at + 1, 2, "  ") != 0) lines.insert(at + 1, "  ");
  }
  return lines;
}

}  // namespace

const char* severity_name(Severity severity) {
  switch (severity) {
    case Severity::note:
      return "note";
    case Severity::warning:
      return "warning";
    case Severity::error:
      return "error";
  }
  return "error";
}

std::string place_of(const Diagnostic& diagnostic) {
  if (diagnostic.file.empty()) return {};
  const std::string file = printable(diagnostic.file);
  return diagnostic.line == 0 ? file + ": " : fmt::format("{}:{}: ", file, diagnostic.line);
}

std::string fault_of(const Diagnostic& diagnostic) {
  const std::string fault = indented(diagnostic.fault);
  return diagnostic.element.empty() ? fault : printable(diagnostic.element) + ": " + fault;
}

std::string remedy_of(const Diagnostic& diagnostic) {
  if (diagnostic.remedy.empty()) return {};
  std::string lines = "\n  ";
  for (const char c : printable_lines(diagnostic.remedy)) {
    lines += c;
    if (c == '\n') lines += "  ";
  }
  return lines;
}

std::string to_string(const Diagnostic& diagnostic) {
  return place_of(diagnostic) + severity_name(diagnostic.severity) + ": " + fault_of(diagnostic) +
         remedy_of(diagnostic);
}

}  // namespace treeline
