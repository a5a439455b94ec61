// What this code is, for whoever finds it in a binary: the version of Treeline, and the SHA-256 of
// what `LC_ALL=C sha256sum` prints of all other files in order of their names, but manifest.json.
// Generated.
#include "ur10e.hpp"

const char ur10e_id[93] =
    "treeline 0.1.0 ur10e sha256 "
    "2c4c7a2d82f931ca49beee85aa382bad72f5cd4527647d625134ab4ff18f3d19";
