// What this code is, for whoever finds it in a binary: the version of Treeline, and the SHA-256 of
// what `LC_ALL=C sha256sum` prints of all other files in order of their names, but manifest.json.
// Generated.
#include "ur10e.hpp"

const char ur10e_id[93] =
    "treeline 0.1.0 ur10e sha256 "
    "d748bf24d91496441e17b2a3e7b62804916fead1b830a41db369b356b483cc3a";
