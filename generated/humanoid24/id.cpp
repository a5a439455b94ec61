// What this code is, for whoever finds it in a binary: the version of Treeline, and the SHA-256 of
// what `LC_ALL=C sha256sum` prints of all other files in order of their names, but manifest.json.
// Generated.
#include "humanoid24.hpp"

const char humanoid24_id[98] =
    "treeline 0.1.0 humanoid24 sha256 "
    "c7d1e0d138b7b51c4eff9ac0c110d877d676e3aa0f227c7f8d0c55b29e22f4af";
