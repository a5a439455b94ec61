#!/usr/bin/env bash
# Times fresh copies of PROGRAMs, which are the same but for where code comes to lie in memory, and
# prints the table of all: that place changes the time of a large function by up to a half, and a
# file keeps its own.
# Usage: run_report.sh FOLDER PROGRAM... -- OPTION... (FOLDER: for what is written)
set -euo pipefail
folder=$1
shift
programs=()
while [[ $1 != -- ]]; do
  programs+=("$1")
  shift
done
shift
times=$folder/times.txt
copy=$folder/treeline_bench.copy
trap 'rm -f "$copy" "$times"' EXIT
rm -f "$times"
for program in "${programs[@]}"; do
  rm -f "$copy"
  cp "$program" "$copy"
  echo "$program" >&2
  "$copy" --times="$times" --json="$folder/bench.jsonl" --plot="$folder/bench.svg" \
    --benchmark_repetitions=3 "$@" >"$folder/bench.txt"
done
cat "$folder/bench.txt"
