// SPDX-License-Identifier: 0BSD
// What this code is, for whoever finds it in a binary: the version of Treeline, and the SHA-256 of
// what `LC_ALL=C sha256sum` prints of all other files in order of their names, but manifest.json.
// Generated.
#include "ur10e.hpp"

const char ur10e_id[93] =
    "treeline 0.9.0 ur10e sha256 "
    "ea93ac95f70ceb4aa091428e17f48941afde3580d33626a318a96935d3a0a26f";
