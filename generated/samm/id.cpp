// SPDX-License-Identifier: 0BSD
// What this code is, for whoever finds it in a binary: the version of Treeline, and the SHA-256 of
// what `LC_ALL=C sha256sum` prints of all other files in order of their names, but manifest.json.
// Generated.
#include "samm.hpp"

const char samm_id[92] =
    "treeline 0.9.0 samm sha256 "
    "9076c97f444703bfd573fb1bbad4268debf07b7911f81383474794eb394fd03d";
