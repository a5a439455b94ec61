#pragma once

#include <optional>
#include <string>
#include <vector>

#include "text/diagnostic.hpp"

namespace treeline {

/// Statement of a report about one function, in the report's own words.
struct EvidenceRow {
  std::string function;
  std::vector<std::string> cells;
};

/// A report of `treeline check`, `check --target` or `certify`, in short.
struct Evidence {
  std::string file, digest;  ///< name without folders, SHA-256
  std::string kind;          ///< what was done
  bool passed = false;
  std::string stale;                 ///< what else it was made for; empty: for these files
  std::vector<std::string> facts;    ///< sentences about the whole report
  std::vector<std::string> columns;  ///< of `rows`, after the function's name
  std::vector<EvidenceRow> rows;
};

/// Subject that a report must be about.
struct EvidenceSubject {
  std::string name;    ///< of the robot
  std::string digest;  ///< of the files, see `digest_of_files`: other inputs or options give others
};

/// Reads a report that one of these subcommands printed with --json. It is stale where its version
/// or the digest of its files is another. Errors: the file cannot be read, is no such report, or is
/// one of another robot.
std::optional<Evidence> read_evidence(const std::string& path, const EvidenceSubject& subject,
                                      Diagnostics& diagnostics);

}  // namespace treeline
