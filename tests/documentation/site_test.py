#!/usr/bin/env python3
"""Builds the site as mkdocs.yml says and looks for words that people bring along.

Usage: site_test.py ENVIRONMENT SOURCES FOLDER. Would catch: a link or an anchor that leads nowhere, a page that the
contents do not list, a comment in a header that Doxygen does not understand, and a word of another library that the
search does not know.
"""

import json
import os
import re
import shutil
import subprocess
import sys

# A word, and a page one of whose headings has it, which the search puts before all text.
TITLED = {
    "end effector": "docs/how-to/tool-frame/",
    "inverse kinematics": "docs/how-to/inverse-kinematics/",
    "thread": "docs/how-to/threads/",
    "cite": "docs/",
    "upgrade": "docs/start/install/",
    "payload": "docs/how-to/payload/",
    "gravity": "docs/how-to/gravity/",
    "Python": "docs/how-to/python/",
    "torque_limits": "docs/reference/scene/",
    "doctor": "docs/reference/commands/",
    "watchdog": "docs/reference/controller/",
    "STM32": "docs/how-to/microcontroller/",
    "Zephyr": "docs/how-to/microcontroller/",
    "FreeRTOS": "docs/how-to/microcontroller/",
    "CAN": "docs/how-to/microcontroller/",
    "gravity compensation": "examples/arm_gravity_compensation/",
}
# A word, and a page whose text has it.
MENTIONED = {
    "IK": "docs/explanation/glossary/",
    "CRBA": "docs/explanation/glossary/",
    "package://": "docs/how-to/meshes/",
    "ROS 2": "docs/explanation/glossary/",
    "JointState": "docs/how-to/ros/",
    "exit status": "docs/reference/commands/",
    "uninstall": "docs/start/install/",
    "trajectory": "docs/explanation/glossary/",
    "MPC": "docs/explanation/glossary/",
    "PREEMPT_RT": "docs/explanation/glossary/",
    "GIL": "docs/explanation/glossary/",
    "Windows": "docs/start/install/",
}


def build(environment, sources, folder):
    """Warnings of MkDocs are errors; pages that the contents do not list are those that it tells of beside."""
    run = subprocess.run([os.path.join(environment, "bin/mkdocs"), "build", "--strict", "--site-dir", folder],
                         cwd=sources, capture_output=True, text=True, check=False)
    unlisted = re.search(r"not included in the \"nav\" configuration:\n((?: +- .*\n)+)", run.stderr)
    faults = [f"mkdocs.yml does not list\n{unlisted[1]}"] if unlisted else []
    return faults + ([run.stderr] if run.returncode else [])


def finds(entries, word, page, parts):
    """Whether a section of the page has the word in one of the parts of its entry."""
    return any(entry["location"].split("#")[0] == page and word.lower() in entry[part].lower()
               for entry in entries for part in parts)


def main():
    environment, sources, folder = (os.path.abspath(path) for path in sys.argv[1:])
    if not os.path.exists(os.path.join(environment, "bin/mkdocs")):
        print("skipped: MkDocs is not installed, see documentation.install")
        return 0
    faults = build(environment, sources, folder)
    if not faults:
        with open(os.path.join(folder, "search/search_index.json"), encoding="utf-8") as file:
            index = json.load(file)
        loop = os.path.join(folder, "headers/classtreeline_1_1servo_1_1ServoLoop.html")
        if shutil.which("doxygen") and not os.path.exists(loop):
            faults.append("the site lacks the headers' pages, such as that of servo::ServoLoop")
        if "stopWordFilter" in index["config"]["pipeline"]:
            faults.append("the search leaves out CAN, a word of its list")
        for words, parts in ((TITLED, ("title",)), (MENTIONED, ("title", "text"))):
            faults += [f"the search does not find {word} on {page}, in {' or '.join(parts)}"
                       for word, page in words.items() if not finds(index["docs"], word, page, parts)]
    print(*faults, f"{len(faults)} faults", sep="\n")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
