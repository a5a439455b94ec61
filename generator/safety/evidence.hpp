#pragma once

#include <optional>
#include <string>
#include <vector>

#include "text/diagnostic.hpp"

namespace treeline {

/// What a report says of one function, in the report's own words.
struct EvidenceRow {
  std::string function;
  std::vector<std::string> cells;
};

/// A report of `treeline check`, `check --target` or `certify`, in short.
struct Evidence {
  std::string file, digest;  ///< name without folders, SHA-256
  std::string kind;          ///< what was done
  bool passed = false;
  std::vector<std::string> facts;    ///< sentences about the whole report
  std::vector<std::string> columns;  ///< of `rows`, after the function's name
  std::vector<EvidenceRow> rows;
};

/// Reads a report that one of these subcommands printed with --json, for the robot of that name.
/// Errors: the file cannot be read, is no such report, or is one of another robot.
std::optional<Evidence> read_evidence(const std::string& path, const std::string& name,
                                      Diagnostics& diagnostics);

}  // namespace treeline
