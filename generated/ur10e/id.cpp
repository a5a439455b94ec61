// What this code is, for whoever finds it in a binary: the version of Treeline, and the SHA-256 of
// what `LC_ALL=C sha256sum` prints of all other files in order of their names, but manifest.json.
// Generated.
#include "ur10e.hpp"

const char ur10e_id[93] =
    "treeline 0.1.0 ur10e sha256 "
    "c6a232e57d18d51387ead4343a127f4bf8cf40bc3d4c7448b370dc0ff3ff30d8";
