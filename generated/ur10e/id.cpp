// What this code is, for whoever finds it in a binary: the version of Treeline, and the SHA-256 of
// what `LC_ALL=C sha256sum` prints of all other files in order of their names, but manifest.json.
// Generated.
#include "ur10e.hpp"

const char ur10e_id[93] =
    "treeline 0.1.0 ur10e sha256 "
    "3cb4d11a228bb103a7910f190330486ab958d560189d5a6010461726fd84c073";
