// What this code is, for whoever finds it in a binary: the version of Treeline, and the SHA-256 of
// what `LC_ALL=C sha256sum` prints of all other files in order of their names, but manifest.json.
// Generated.
#include "puma560.hpp"

const char puma560_id[95] =
    "treeline 0.1.0 puma560 sha256 "
    "5fd80af55ab19f76f61deeab948ab0d5a61becc9d5a5a865a905b899af7890d2";
