// What this code is, for whoever finds it in a binary: the version of Treeline, and the SHA-256 of
// what `LC_ALL=C sha256sum` prints of all other files in order of their names, but manifest.json.
// Generated.
#include "puma560.hpp"

const char puma560_id[95] =
    "treeline 0.1.0 puma560 sha256 "
    "e0e1760f7103f544012165a6004d5edf017c2209c93401b7b4f73a60c27ab084";
