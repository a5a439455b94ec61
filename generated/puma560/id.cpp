// SPDX-License-Identifier: 0BSD
// What this code is, for whoever finds it in a binary: the version of Treeline, and the SHA-256 of
// what `LC_ALL=C sha256sum` prints of all other files in order of their names, but manifest.json.
// Generated.
#include "puma560.hpp"

const char puma560_id[95] =
    "treeline 0.9.0 puma560 sha256 "
    "c892b095acc0ccb2a556eed6a4db062b6949787a97cbabbb0f4f2bc54e5db1d9";
