// SPDX-License-Identifier: 0BSD
// What this code is, for whoever finds it in a binary: the version of Treeline, and the SHA-256 of
// what `LC_ALL=C sha256sum` prints of all other files in order of their names, but manifest.json.
// Generated.
#include "ur10e.hpp"

const char ur10e_id[93] =
    "treeline 0.9.0 ur10e sha256 "
    "98a45f3e0381c638aff0dc21f05c63bb9bd32a1ce13511869da63a0dca2f3a0e";
