// What this code is, for whoever finds it in a binary: the version of Treeline, and the SHA-256 of
// what `LC_ALL=C sha256sum` prints of all other files in order of their names, but manifest.json.
// Generated.
#include "puma560.hpp"

const char puma560_id[95] =
    "treeline 0.1.0 puma560 sha256 "
    "e17fd33a358e009dfcd5e3d48927a37d694e50ebdca513c3590bb02a426d8ad4";
