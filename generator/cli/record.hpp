#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cli/read_inputs.hpp"
#include "driving/page_server.hpp"
#include "text/diagnostic.hpp"

namespace treeline {

/// A recorded drive, which the page can show again.
struct Record {
  std::string hello;                ///< message of this type
  std::vector<double> times;        ///< of states, s, growing
  std::vector<std::string> states;  ///< messages of this type
};

/// Reads a file of `treeline drive --record`. `checksum`: of the robot's files. Errors: no record;
/// one of other files.
std::optional<Record> read_record(const std::string& path, const std::string& checksum,
                                  Diagnostics& diagnostics);

/// Whether the file is a table and no record, which is lines of JSON.
bool is_table(const std::string& path);

/// Makes a record of a table as `treeline draw --motion` takes it, 100 states a second at most. A
/// table does not say how fast joints were and what forces they had: `qd` and `tau` of the states
/// are empty, and their mode is `replay`. Errors: those of reading; ball joints, which the page
/// cannot show.
std::optional<Record> record_of_table(const std::string& path, const RobotAndScene& inputs,
                                      const std::string& checksum, Diagnostics& diagnostics);

/// Shows a record in the page, in real time and again from its beginning, until a signal comes.
/// There is no loop, and nothing can be commanded. Errors: an address that cannot be listened on.
bool replay(const Record& record, const PageSettings& page, Diagnostics& diagnostics);

}  // namespace treeline
