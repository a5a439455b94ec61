// What this code is, for whoever finds it in a binary: the version of Treeline, and the SHA-256 of
// what `LC_ALL=C sha256sum` prints of all other files in order of their names, but manifest.json.
// Generated.
#include "humanoid24.hpp"

const char humanoid24_id[98] =
    "treeline 0.1.0 humanoid24 sha256 "
    "2d4fb50f4dbc28b37d3a747846dfb64b11280a944f5c6cbf9c1f0c899b1aa42f";
