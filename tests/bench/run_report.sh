#!/usr/bin/env bash
# Times PROGRAM in three fresh copies of it and prints the table of all: where code comes to lie in
# memory changes the time of a large function by up to a half, and a file keeps its place.
# Usage: run_report.sh PROGRAM FOLDER OPTION... (PROGRAM: treeline_bench; FOLDER: for what it writes)
set -euo pipefail
program=$1 folder=$2
shift 2
times=$folder/times.txt
copy=$folder/$(basename "$program").copy
trap 'rm -f "$copy" "$times"' EXIT
rm -f "$times"
for run in 1 2 3; do
  rm -f "$copy"
  cp "$program" "$copy"
  echo "run $run of 3" >&2
  "$copy" --times="$times" --json="$folder/bench.jsonl" --plot="$folder/bench.svg" \
    --benchmark_repetitions=3 "$@" >"$folder/bench.txt"
done
cat "$folder/bench.txt"
