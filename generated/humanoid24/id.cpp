// SPDX-License-Identifier: 0BSD
// What this code is, for whoever finds it in a binary: the version of Treeline, and the SHA-256 of
// what `LC_ALL=C sha256sum` prints of all other files in order of their names, but manifest.json.
// Generated.
#include "humanoid24.hpp"

const char humanoid24_id[98] =
    "treeline 0.9.0 humanoid24 sha256 "
    "148d951b221e0c3e43957cb53a78d39e8f81fb526a1a3d7c1a6e6534d05eeb01";
