// SPDX-License-Identifier: 0BSD
// What this code is, for whoever finds it in a binary: the version of Treeline, and the SHA-256 of
// what `LC_ALL=C sha256sum` prints of all other files in order of their names, but manifest.json.
// Generated.
#include "puma560.hpp"

const char puma560_id[95] =
    "treeline 0.9.0 puma560 sha256 "
    "0fb2e2b6d2ba9b30be538375dc3e36e3189fc3c829e885319b1e397bd4d07edf";
