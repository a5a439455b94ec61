#include "description/diagnostic.hpp"

#include <fmt/format.h>

namespace treeline {
namespace {

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

}  // namespace

std::string to_string(const Diagnostic& diagnostic) {
  std::string text = diagnostic.file;
  if (!diagnostic.file.empty() && diagnostic.line > 0) text += fmt::format(":{}", diagnostic.line);
  if (!text.empty()) text += ": ";
  text += severity_name(diagnostic.severity);
  text += ": ";
  if (!diagnostic.element.empty()) text += diagnostic.element + ": ";
  text += diagnostic.fault;
  if (!diagnostic.remedy.empty()) text += "\n  " + diagnostic.remedy;
  return text;
}

}  // namespace treeline
