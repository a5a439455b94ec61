// What this code is, for whoever finds it in a binary: the version of Treeline, and the SHA-256 of
// what `LC_ALL=C sha256sum` prints of all other files in order of their names, but manifest.json.
// Generated.
#include "humanoid24.hpp"

const char humanoid24_id[98] =
    "treeline 0.1.0 humanoid24 sha256 "
    "cd0d127dc6f94dcb85900e02bbc2c4bfbe1b85f004a84988c51eab8c89a05769";
