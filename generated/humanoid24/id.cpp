// SPDX-License-Identifier: 0BSD
// What this code is, for whoever finds it in a binary: the version of Treeline, and the SHA-256 of
// what `LC_ALL=C sha256sum` prints of all other files in order of their names, but manifest.json.
// Generated.
#include "humanoid24.hpp"

const char humanoid24_id[98] =
    "treeline 0.9.0 humanoid24 sha256 "
    "2419792671edeac84019d5e112ddfceccf6b502176f2ae0fff0cf46ac76d6064";
