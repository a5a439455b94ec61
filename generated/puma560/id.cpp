// SPDX-License-Identifier: 0BSD
// What this code is, for whoever finds it in a binary: the version of Treeline, and the SHA-256 of
// what `LC_ALL=C sha256sum` prints of all other files in order of their names, but manifest.json.
// Generated.
#include "puma560.hpp"

const char puma560_id[95] =
    "treeline 0.9.0 puma560 sha256 "
    "6fa7655c57515acfb6702163fd96c16026c53e3dd872fe05fb395cd57ad888b8";
