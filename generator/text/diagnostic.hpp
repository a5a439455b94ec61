#pragma once

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

namespace treeline {

enum class Severity { note, warning, error };

/// Faults of form that change no equation of motion: what other programs write into a URDF. An
/// exported robot has hundreds; they are told as one line with a count of each kind.
enum class Minor {
  none,       ///< no such fault: told by itself
  attribute,  ///< not part of URDF
  element,    ///< not part of URDF
  text,       ///< between elements
  limit,      ///< missing, and counts as none
  form,       ///< anything else about how the file is written
};

/// One thing to tell the user about an input: where, what is wrong, what to do about it.
struct Diagnostic {
  Severity severity = Severity::error;
  std::string file;     ///< path as the user gave it; empty when the fault is in no file
  int line = 0;         ///< 1-based; 0 when unknown
  std::string element;  ///< path of the element, e.g. `robot/joint[elbow]/axis`; may be empty
  std::string fault;    ///< what is wrong, one sentence without a full stop
  std::string remedy;   ///< what to do, one sentence, or lines of a list; may be empty for notes
  Minor minor = Minor::none;
  int times = 1;  ///< how many of the kind this one stands for
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

/// `note`, `warning` or `error`.
const char* severity_name(Severity severity);

/// `file:line: ` of a diagnostic; empty when it is about no file.
std::string place_of(const Diagnostic& diagnostic);

/// `element: fault`.
std::string fault_of(const Diagnostic& diagnostic);

/// The remedy, each of its lines indented and begun by a line break; empty when there is none.
std::string remedy_of(const Diagnostic& diagnostic);

/// `file:line: error: element: fault`, indented below it the remedy; all of it, and of the parts
/// above, `printable`.
std::string to_string(const Diagnostic& diagnostic);

}  // namespace treeline
