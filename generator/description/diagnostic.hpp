#pragma once

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

namespace treeline {

enum class Severity { note, warning, error };

/// One thing to tell the user about an input: where, what is wrong, what to do about it.
struct Diagnostic {
  Severity severity = Severity::error;
  std::string file;     ///< path as the user gave it; empty when the fault is in no file
  int line = 0;         ///< 1-based; 0 when unknown
  std::string element;  ///< path of the element, e.g. `robot/joint[elbow]/axis`; may be empty
  std::string fault;    ///< what is wrong, one sentence without a full stop
  std::string remedy;   ///< what to do, one sentence; may be empty for notes
};

/// Everything there is to say about one run, in the order it was found.
class Diagnostics {
 public:
  void add(Diagnostic diagnostic) { list_.push_back(std::move(diagnostic)); }

  [[nodiscard]] bool has_errors() const {
    return std::any_of(list_.begin(), list_.end(),
                       [](const Diagnostic& d) { return d.severity == Severity::error; });
  }
  [[nodiscard]] const std::vector<Diagnostic>& list() const { return list_; }

 private:
  std::vector<Diagnostic> list_;
};

/// `file:line: error: element: fault` and, indented on the next line, the remedy.
std::string to_string(const Diagnostic& diagnostic);

}  // namespace treeline
