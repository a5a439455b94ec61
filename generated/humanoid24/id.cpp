// SPDX-License-Identifier: 0BSD
// What this code is, for whoever finds it in a binary: the version of Treeline, and the SHA-256 of
// what `LC_ALL=C sha256sum` prints of all other files in order of their names, but manifest.json.
// Generated.
#include "humanoid24.hpp"

const char humanoid24_id[98] =
    "treeline 0.9.0 humanoid24 sha256 "
    "be6973708d9f4816db2db8e94929c244fd2454d7149d5ac8860f9fc5cfd0a68e";
