#!/usr/bin/env bash
# Fuzzes steps of emitted controllers, a PUMA with every law and a gantry with a joint that turns
# without end, with the address and undefined-behaviour sanitizers.
# Usage: fuzz_step.sh TREELINE SOURCE FOLDER [SECONDS]; SOURCE is the repository. Without SECONDS a
# minute or so from a fixed seed; with SECONDS as long, from a new seed, which is printed. Inputs
# that break something stay in FOLDER. Exit 77 (skipped) where clang or its fuzzer is missing.
set -euo pipefail
treeline=$(realpath "$1") source_dir=$(realpath "$2") folder=$(realpath -m "$3") seconds=${4:-}
clang=$(command -v clang++ || true)
if [ -z "$clang" ]; then
  echo "skipped: clang++ is missing (Debian package clang)"
  exit 77
fi
rm -rf "$folder/corpus"
mkdir -p "$folder/corpus"
cd "$folder"
if ! echo 'extern "C" int LLVMFuzzerTestOneInput(const unsigned char*, unsigned long) { return 0; }' |
    "$clang" -x c++ -fsanitize=fuzzer,address,undefined - -o probe 2>/dev/null; then
  echo "skipped: the fuzzer runtime of $clang is missing (Debian package libclang-rt-dev)"
  exit 77
fi
tests=$source_dir/tests/controller
rm -rf puma_arm gantry
cp "$tests/puma.yaml" .
cmake -DFILE=puma.yaml -P "$tests/add_behaviours.cmake"
"$treeline" generate "$source_dir/robots/puma560/puma560.urdf" puma.yaml --output puma_arm
"$treeline" generate "$tests/safe_state/turning_gantry.urdf" "$tests/safe_state/gantry.yaml" \
  --name gantry --output gantry
"$clang" -std=c++17 -O1 -g1 -fno-omit-frame-pointer -ffp-contract=off \
  -fsanitize=fuzzer,address,undefined,float-cast-overflow -fno-sanitize-recover=all \
  -Ipuma_arm -Igantry puma_arm/controller*.cpp gantry/controller*.cpp \
  "$tests/fuzz/fuzz_step.cpp" -o fuzz_step
length=(-runs=60000 -seed=1)
[ -z "$seconds" ] || length=(-max_total_time="$seconds" -seed="$(date +%s)")
echo "fuzz_step ${length[*]}"
./fuzz_step corpus "${length[@]}" -max_len=4096 -len_control=20 -timeout=20 \
  -artifact_prefix="$folder/" -print_final_stats=1 2>&1 | tail -40
