// SPDX-License-Identifier: 0BSD
// What this code is, for whoever finds it in a binary: the version of Treeline, and the SHA-256 of
// what `LC_ALL=C sha256sum` prints of all other files in order of their names, but manifest.json.
// Generated.
#include "samm.hpp"

const char samm_id[92] =
    "treeline 0.9.0 samm sha256 "
    "bbc63db6bf6285d7b820d8b20ed20bc2c67e81eb8d815f40c5631d5c50ce0d47";
