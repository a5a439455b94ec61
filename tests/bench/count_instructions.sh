#!/usr/bin/env bash
# Instructions a call of every generated function, counted by callgrind, which gives the same figures
# on every run. Compiled for x86-64-v3, because valgrind knows no AVX-512.
# Usage: count_instructions.sh PROGRAM ROBOT... (PROGRAM: treeline_bench_calls)
set -euo pipefail
program=$1
shift
counts=$(mktemp)
trap 'rm -f "$counts"' EXIT
printf '%-12s %-28s %12s\n' robot function instructions
for robot in "$@"; do
  valgrind --tool=callgrind --callgrind-out-file="$counts" -q "$program" "$robot" >/dev/null
  callgrind_annotate --threshold=100 "$counts" | tr -d , |
    awk -v robot="$robot" -v calls=64 '
      match($0, robot "_gcc_v3::[a-z_]+") {
        split(substr($0, RSTART, RLENGTH), name, "::")
        count[name[2]] += $1
      }
      END {
        n = split("inverse_dynamics forward_dynamics mass_matrix lambda_inverse lambda control_torque inverse_dynamics_derivatives forward_dynamics_derivatives", order, " ")
        for (i = 1; i <= n; ++i) if (order[i] in count) printf "%-12s %-28s %12.0f\n", robot, order[i], count[order[i]] / calls
      }'
done
