// SPDX-License-Identifier: 0BSD
// What this code is, for whoever finds it in a binary: the version of Treeline, and the SHA-256 of
// what `LC_ALL=C sha256sum` prints of all other files in order of their names, but manifest.json.
// Generated.
#include "humanoid24.hpp"

const char humanoid24_id[98] =
    "treeline 0.9.0 humanoid24 sha256 "
    "66d84ec23e3ccf34a8e7fe4766c6516977677b7d93d3dbf5ee730d7cdc9f0b6f";
