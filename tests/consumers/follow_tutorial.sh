#!/usr/bin/env bash
# Follows docs/tutorials/controller.md to the letter, in an empty folder, with an installed treeline; then with
# other arms, from three joints to a gripper that mimics, and the law that the page shows.
# Would catch a command that fails, a file that differs from the one that is shown, a controller that does not
# reach its goal, a program that is written for one robot, and sources that are compiled though they are empty.
# Usage: follow_tutorial.sh SOURCES PREFIX FOLDER
set -euo pipefail
sources=$1 prefix=$2 folder=$3
page=$sources/docs/tutorials/controller.md
tutorial=$sources/tests/consumers/tutorial

# The generated function that README.md shows.
shown=$(awk '/^```cpp$/ {shown = 1; next} /^```$/ {shown = 0} shown {print}' "$sources/README.md")
header=$(<"$sources/generated/puma560/puma560.hpp")
if [[ -z $shown || $header != *"$shown"* ]]; then
  echo "README.md shows another gravity() than generated/puma560/puma560.hpp has:" >&2
  echo "$shown" >&2
  exit 1
fi

reached="tool moved by 0[.][0-9]* m .*largest position error [0-9.]*e-0[5-9] m"
expect_full_sources() {
  if grep -L "#include" build/treeline/arm/arm.sources/*.cpp | grep .; then
    echo "these sources are empty" >&2
    exit 1
  fi
}

"$sources/tests/documentation/run_page.py" "$page" "$sources" "$prefix" "$folder" own_law.txt | tee "$folder.output"
grep -q "$reached" "$folder.output"
cd "$folder/work"
diff CMakeLists.txt "$tutorial/CMakeLists.txt"
expect_full_sources
own_law=$PWD/own_law.txt
export HOME=$folder/home PATH=$prefix/bin:$PATH

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
sed -i -e "/    pose_.control(time, state, tau);/{r $own_law" -e "d}" reach.cpp
cmake --build build >> log
./build/reach | tee output
grep -q "tool moved by 0.0000 m" output
