// What this code is, for whoever finds it in a binary: the version of Treeline, and the SHA-256 of
// what `LC_ALL=C sha256sum` prints of all other files in order of their names, but manifest.json.
// Generated.
#include "ur10e.hpp"

const char ur10e_id[93] =
    "treeline 0.1.0 ur10e sha256 "
    "230be7a88b3946478f7f29339dd2242ebfa9b3f9bc57e6eb40607a0e46cb60e8";
