// SPDX-License-Identifier: 0BSD
// What this code is, for whoever finds it in a binary: the version of Treeline, and the SHA-256 of
// what `LC_ALL=C sha256sum` prints of all other files in order of their names, but manifest.json.
// Generated.
#include "puma560.hpp"

const char puma560_id[95] =
    "treeline 0.9.0 puma560 sha256 "
    "6daab895f4980c13f87ea46f7a0ce79ff48c8737bc386bb5145eaaa5f9cb7d64";
