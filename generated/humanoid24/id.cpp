// What this code is, for whoever finds it in a binary: the version of Treeline, and the SHA-256 of
// what `LC_ALL=C sha256sum` prints of all other files in order of their names, but manifest.json.
// Generated.
#include "humanoid24.hpp"

const char humanoid24_id[98] =
    "treeline 0.1.0 humanoid24 sha256 "
    "28e3fd98b10bfcff89825bff7e0271e2cc3641ad560bb7e8493204d948d074ab";
