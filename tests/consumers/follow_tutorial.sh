#!/usr/bin/env bash
# Follows the tutorial of README.md to the letter, in an empty folder, with an installed treeline; then with
# other arms, from three joints to a gripper that mimics, and the law that the page shows.
# Would catch a command that fails, a file that differs from the one that is shown, a controller that does not
# reach its goal, a program that is written for one robot, and sources that are compiled though they are empty.
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
     kind == "c++" {print > "shown/own_law.txt"}
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

reached="tool moved by 0[.][0-9]* m .*largest position error [0-9.]*e-0[5-9] m"
expect_full_sources() {
  if grep -L "#include" build/treeline/arm/arm.sources/*.cpp | grep .; then
    echo "these sources are empty" >&2
    exit 1
  fi
}

cd work
export HOME=$folder/home PATH=$prefix/bin:$PATH TREELINE=$sources
bash -euxo pipefail ../commands.sh | tee ../output
grep -q "$reached" ../output
expect_full_sources

# reach DESCRIPTION URDF: what the tutorial builds, of another robot.
reach() {
  mkdir -p "../$1"
  cd "../$1"
  cp "$2" arm.urdf
  cp "$tutorial"/{CMakeLists.txt,reach.cpp} .
  treeline init-scene arm.urdf --output arm.yaml > /dev/null 2>&1
  cmake -S . -B build -DCMAKE_BUILD_TYPE=Release -DCMAKE_PREFIX_PATH="$prefix" > log
  cmake --build build >> log
  ./build/reach | tee output
  grep -q "$reached" output
  expect_full_sources
}
reach three_joints "$sources/robots/planar3r/planar3r.urdf"
reach gripper "$sources/tests/data/published/kinova_gen3_2f85.urdf"
reach seven_joints "$sources/tests/data/published/iiwa14_drake.urdf"

# The law that the page shows, which asks for no motion.
sed -i -e "/    pose_.control(time, state, tau);/{r ../shown/own_law.txt" -e "d}" reach.cpp
cmake --build build >> log
./build/reach | tee output
grep -q "tool moved by 0.0000 m" output
