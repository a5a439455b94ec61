// What this code is, for whoever finds it in a binary: the version of Treeline, and the SHA-256 of
// what `LC_ALL=C sha256sum` prints of all other files in order of their names, but manifest.json.
// Generated.
#include "samm.hpp"

const char samm_id[92] =
    "treeline 0.1.0 samm sha256 "
    "9796feb689b89c9cf5f5dbe207e30e08f70a0f193ef9dee02d76aa98b52de9ec";
