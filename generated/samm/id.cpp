// What this code is, for whoever finds it in a binary: the version of Treeline, and the SHA-256 of
// what `LC_ALL=C sha256sum` prints of all other files in order of their names, but manifest.json.
// Generated.
#include "samm.hpp"

const char samm_id[92] =
    "treeline 0.1.0 samm sha256 "
    "e9554251a99ba05039d5ccc820c3d0a11badc65c289fa0e873fdb59ce7a1f5dc";
