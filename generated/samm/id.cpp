// SPDX-License-Identifier: 0BSD
// What this code is, for whoever finds it in a binary: the version of Treeline, and the SHA-256 of
// what `LC_ALL=C sha256sum` prints of all other files in order of their names, but manifest.json.
// Generated.
#include "samm.hpp"

const char samm_id[92] =
    "treeline 0.9.0 samm sha256 "
    "5b1368b412ccc112e3d0be011e42ec8f582597a7794de0b7feee6ada88415cb1";
