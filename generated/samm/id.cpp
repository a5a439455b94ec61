// What this code is, for whoever finds it in a binary: the version of Treeline, and the SHA-256 of
// what `LC_ALL=C sha256sum` prints of all other files in order of their names, but manifest.json.
// Generated.
#include "samm.hpp"

const char samm_id[92] =
    "treeline 0.1.0 samm sha256 "
    "b5cad8b1b6126c2e1d76fba0709c86b46272bdb3ae622a822e5b62ca41132de0";
