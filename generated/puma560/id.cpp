// What this code is, for whoever finds it in a binary: the version of Treeline, and the SHA-256 of
// what `LC_ALL=C sha256sum` prints of all other files in order of their names, but manifest.json.
// Generated.
#include "puma560.hpp"

const char puma560_id[95] =
    "treeline 0.1.0 puma560 sha256 "
    "3eb2b4d45f3ad8efca56c1160135449b77ba8930a08646124c3feed5266ebfd8";
