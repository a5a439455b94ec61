#!/usr/bin/env python3
"""Builds the site as mkdocs.yml says and looks for words that people bring along.

Usage: site_test.py ENVIRONMENT SOURCES FOLDER. Would catch: a link or an anchor that leads nowhere, a page that the
contents do not list, and a word of another library that the search does not know.
"""

import json
import os
import re
import subprocess
import sys

# A word, and a page on which the search has to find it.
SOUGHT = {
    "end effector": "docs/how-to/tool-frame/",
    "inverse kinematics": "docs/how-to/inverse-kinematics/",
    "IK": "docs/explanation/glossary/",
    "CRBA": "docs/explanation/glossary/",
    "thread": "docs/how-to/threads/",
    "cite": "docs/",
    "upgrade": "docs/start/install/",
    "payload": "docs/how-to/payload/",
    "gravity": "docs/how-to/gravity/",
    "Python": "docs/how-to/python/",
    "package://": "docs/how-to/meshes/",
    "torque_limits": "docs/reference/scene/",
    "ROS 2": "docs/explanation/glossary/",
    "JointState": "docs/how-to/ros/",
    "STM32": "docs/how-to/microcontroller/",
    "exit status": "docs/reference/commands/",
    "doctor": "docs/start/install/",
    "uninstall": "docs/start/install/",
    "watchdog": "docs/explanation/glossary/",
    "trajectory": "docs/explanation/glossary/",
    "MPC": "docs/explanation/glossary/",
    "Windows": "docs/start/install/",
    "gravity compensation": "examples/arm_gravity_compensation/",
}


def build(environment, sources, folder):
    """Warnings of MkDocs are errors; pages that the contents do not list are those that it tells of beside."""
    run = subprocess.run([os.path.join(environment, "bin/mkdocs"), "build", "--strict", "--site-dir", folder],
                         cwd=sources, capture_output=True, text=True, check=False)
    unlisted = re.search(r"not included in the \"nav\" configuration:\n((?: +- .*\n)+)", run.stderr)
    faults = [f"mkdocs.yml does not list\n{unlisted[1]}"] if unlisted else []
    return faults + ([run.stderr] if run.returncode else [])


def main():
    environment, sources, folder = (os.path.abspath(path) for path in sys.argv[1:])
    if not os.path.exists(os.path.join(environment, "bin/mkdocs")):
        print("skipped: MkDocs is not installed, see documentation.install")
        return 0
    faults = build(environment, sources, folder)
    if not faults:
        with open(os.path.join(folder, "search/search_index.json"), encoding="utf-8") as file:
            entries = json.load(file)["docs"]
        for word, page in SOUGHT.items():
            if not any(entry["location"].split("#")[0] == page
                       and word.lower() in (entry["title"] + " " + entry["text"]).lower() for entry in entries):
                faults.append(f"the search does not find {word} on {page}")
    print(*faults, f"{len(faults)} faults", sep="\n")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
