// What this code is, for whoever finds it in a binary: the version of Treeline, and the SHA-256 of
// what `LC_ALL=C sha256sum` prints of all other files in order of their names, but manifest.json.
// Generated.
#include "samm.hpp"

const char samm_id[92] =
    "treeline 0.1.0 samm sha256 "
    "8d9252a87ffff7f211f37a426ea601a5276b4dc41294d0254c8538cbd596a522";
