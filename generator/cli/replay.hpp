#pragma once

#include <string>

#include "cli/page_server.hpp"
#include "description/diagnostic.hpp"

namespace treeline {

/// Shows a record of `treeline drive --record` in the page, in real time and again from its
/// beginning, until a signal comes. There is no loop, and nothing can be commanded. `checksum`: of
/// the robot's files. Errors: no record; one of other files; an address that cannot be listened on.
bool replay(const std::string& record, const std::string& checksum, const PageSettings& page,
            Diagnostics& diagnostics);

}  // namespace treeline
