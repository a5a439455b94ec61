#pragma once

#include "cli/record.hpp"
#include "driving/page_server.hpp"
#include "text/diagnostic.hpp"

namespace treeline {

/// Shows a record in the page, in real time and again from its beginning, until a signal comes.
/// There is no loop, and nothing can be commanded. Errors: an address that cannot be listened on.
bool replay(const Record& record, const PageSettings& page, Diagnostics& diagnostics);

}  // namespace treeline
