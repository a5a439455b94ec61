#!/usr/bin/env python3
"""Would catch: an example of `treeline keys` that the program refuses, or that says nothing of its key.

Usage: keys_test.py TREELINE SOURCES FOLDER
"""

import json
import os
import shutil
import subprocess
import sys

# What else has to be in a scene with the example of a key.
NEEDED = {
    "damped": ["operational_points"],
    "controller": ["operational_points"],
    "objects": ["operational_points"],
    "avoidance": ["obstacles"],
    "passive": ["constraints"],
    "torque_limits": ["constraints", "operational_points"],
}
# The examples name what the example of `operational_points` does not have.
POINT = "operational_points: [{name: tool, link: tool}]"


def scene_of(key, examples):
    """A scene with the example of a key and what it needs."""
    parts = [POINT if name == "operational_points" else examples[name] for name in NEEDED.get(key, [])]
    if key == "regressor":
        parts.append("functions: [inverse_dynamics_regressor]")
    return "\n".join([*parts, examples[key]]) + "\n"


def main():
    treeline, sources, folder = (os.path.abspath(path) for path in sys.argv[1:])
    keys = json.loads(subprocess.run([treeline, "keys", "--json"], check=True, capture_output=True, text=True).stdout)
    examples = {key["name"]: key["example"] for key in keys}
    shutil.rmtree(folder, ignore_errors=True)
    os.makedirs(folder)
    for robot in ("puma560", "ur10e"):
        shutil.copy(os.path.join(sources, "robots", robot, f"{robot}.urdf"), folder)
    faults = 0
    for key, example in examples.items():
        if not example.startswith(f"{key}:"):
            print(f"the example of {key} is of another key: {example}")
            faults += 1
        with open(os.path.join(folder, f"{key}.yaml"), "w", encoding="utf-8") as file:
            file.write(scene_of(key, examples))
        robot = [] if key == "robots" else ["puma560.urdf"]
        run = subprocess.run([treeline, "inspect", *robot, f"{key}.yaml", "--summary"], cwd=folder, capture_output=True,
                             text=True, check=False)
        if run.returncode != 0:
            print(f"the example of {key} is refused:\n{run.stderr}")
            faults += 1
    print(f"{len(examples)} examples, {faults} faults")
    return 1 if faults or len(examples) < 30 else 0


if __name__ == "__main__":
    sys.exit(main())
