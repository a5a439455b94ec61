// What this code is, for whoever finds it in a binary: the version of Treeline, and the SHA-256 of
// what `LC_ALL=C sha256sum` prints of all other files in order of their names, but manifest.json.
// Generated.
#include "samm.hpp"

const char samm_id[92] =
    "treeline 0.1.0 samm sha256 "
    "61aa53c9ad90549270f96bbd0918b0ac31c9dfc48c7134dd0c4f857c1164694d";
