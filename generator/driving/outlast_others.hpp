#pragma once

namespace treeline {

/// Readies the process for a robot that is driven: nobody who stops reading what is said or
/// recorded, and no limit on the size of files, ends it, and threads that begin later take little
/// of the memory that is locked. Call this before they begin.
void outlast_others();

}  // namespace treeline
