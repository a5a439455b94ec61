// What this code is, for whoever finds it in a binary: the version of Treeline, and the SHA-256 of
// what `LC_ALL=C sha256sum` prints of all other files in order of their names, but manifest.json.
// Generated.
#include "puma560.hpp"

const char puma560_id[95] =
    "treeline 0.1.0 puma560 sha256 "
    "ac84886109b18fa88fda59c639ea4ae3a68b356aedf6132fd0cb0c9de168b997";
