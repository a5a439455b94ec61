// SPDX-License-Identifier: 0BSD
// What this code is, for whoever finds it in a binary: the version of Treeline, and the SHA-256 of
// what `LC_ALL=C sha256sum` prints of all other files in order of their names, but manifest.json.
// Generated.
#include "samm.hpp"

const char samm_id[92] =
    "treeline 0.9.0 samm sha256 "
    "4842502c9ca520dc42b976c4565903cb78ab7975e37f8bb8cead1865e8f2fcb2";
