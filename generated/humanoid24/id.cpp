// What this code is, for whoever finds it in a binary: the version of Treeline, and the SHA-256 of
// what `LC_ALL=C sha256sum` prints of all other files in order of their names, but manifest.json.
// Generated.
#include "humanoid24.hpp"

const char humanoid24_id[98] =
    "treeline 0.1.0 humanoid24 sha256 "
    "78f991967d8be74957dd31bfd10a6cc397f8677da20c5b714db8f866b56208f0";
