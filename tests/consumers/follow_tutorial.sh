#!/usr/bin/env bash
# Follows the tutorial of README.md to the letter, in an empty folder, with an installed treeline.
# Would catch a command that fails, a file that differs from the one that is shown, and a controller
# that does not reach its goal.
# Usage: follow_tutorial.sh SOURCES PREFIX FOLDER
set -euo pipefail
sources=$1 prefix=$2 folder=$3

rm -rf "$folder"
mkdir -p "$folder/home" "$folder/work" "$folder/shown"
ln -s "$prefix" "$folder/home/.local"
cd "$folder"

# The blocks of the section: commands, the build file, and parts of the program.
awk '/^## /{inside = /^## Tutorial/; next}
     !inside {next}
     /^```./ {kind = substr($0, 4); next}
     /^```$/ {kind = ""; part += 1; next}
     kind == "sh" {print > "commands.sh"}
     kind == "cmake" {print > "shown/CMakeLists.txt"}
     kind == "cpp" {print > ("shown/part_" part ".cpp")}' "$sources/README.md"

# The generated function that README.md shows before.
awk '/^## /{inside = /^## What a generated function/; next}
     inside && /^```cpp$/ && !seen {seen = 1; shown = 1; next}
     /^```$/ {shown = 0}
     shown {print}' "$sources/README.md" > shown/gravity.hpp
header=$(<"$sources/generated/puma560/puma560.hpp")
if [[ ! -s shown/gravity.hpp || $header != *"$(<shown/gravity.hpp)"* ]]; then
  echo "README.md shows another gravity() than generated/puma560/puma560.hpp has:" >&2
  cat shown/gravity.hpp >&2
  exit 1
fi

tutorial=$sources/tests/consumers/tutorial
diff shown/CMakeLists.txt "$tutorial/CMakeLists.txt"
for part in shown/part_*.cpp; do
  program=$(<"$tutorial/reach.cpp")
  if [[ $program != *"$(<"$part")"* ]]; then
    echo "README.md shows what is not in reach.cpp:" >&2
    cat "$part" >&2
    exit 1
  fi
done

# A busy machine may miss the deadlines of real time; the loop then stops, as it should.
sed -i 's/ --realtime$/& || true/' commands.sh

cd work
export HOME=$folder/home PATH=$prefix/bin:$PATH TREELINE=$sources
bash -euxo pipefail ../commands.sh | tee ../output
grep -q "largest position error [0-9.]*e-0[6-9] m" ../output
