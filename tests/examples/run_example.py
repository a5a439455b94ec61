#!/usr/bin/env python3
"""Does what the page of an example says, in a copy of its folder, and compares what comes out with the page.

Usage: run_example.py EXAMPLE SOURCES PREFIX FOLDER [ENVIRONMENT]. PREFIX has an installed treeline, ENVIRONMENT is one
of Python with NumPy. Commands of the page are in blocks `sh`, lines that they print in blocks `text`. With
TREELINE_WRITE_PICTURES=1 the picture of the example is made again.

Would catch: a command that fails, figures and a picture that are not those of this code, and a page without them.
"""

import filecmp
import os
import shutil
import subprocess
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), os.pardir, "documentation"))
from run_page import blocks_of, environment_in, faults_of  # noqa: E402

LARGEST_PICTURE = 60000  # bytes, so that the page of all examples loads at once


def do_as_it_says(blocks, work, environment):
    """What the commands print, all of them, and the exit status of the last."""
    commands = "".join(code for kind, _, code in blocks if kind == "sh")
    run = subprocess.run(["bash", "-euxo", "pipefail", "-c", commands], cwd=work, env=environment, text=True,
                         stdout=subprocess.PIPE, stderr=subprocess.STDOUT, check=False)
    print(run.stdout)
    return run.stdout.splitlines(), run.returncode


def compare_picture(example, work):
    """Compares the picture that was drawn with the one that the page shows; returns faults."""
    drawn, shown = (os.path.join(folder, "picture.svg") for folder in (work, example))
    if os.path.getsize(drawn) > LARGEST_PICTURE:
        return [f"the picture has {os.path.getsize(drawn)} bytes, at most {LARGEST_PICTURE}"]
    if os.environ.get("TREELINE_WRITE_PICTURES") == "1":
        shutil.copy(drawn, shown)
    if not os.path.exists(shown) or not filecmp.cmp(drawn, shown, shallow=False):
        return [f"{shown} is stale: run this test with TREELINE_WRITE_PICTURES=1"]
    return []


def main():
    example, sources, prefix, folder = (os.path.abspath(path) for path in sys.argv[1:5])
    with open(os.path.join(example, "README.md"), encoding="utf-8") as file:
        page = file.read()
    blocks, prose = blocks_of(page)
    environment = environment_in(folder, sources, prefix)
    if len(sys.argv) > 5:
        if not os.path.exists(os.path.join(sys.argv[5], "installed.txt")):
            print("skipped: what it takes is not installed, see packaging.install and examples.debian_environment")
            return 0
        environment["PATH"] = os.path.join(sys.argv[5], "bin") + os.pathsep + environment["PATH"]
        environment |= {"PYTHONPATH": os.path.join(prefix, "share/treeline/python"), "PYTHONWARNINGS": "error"}
    work = os.path.join(folder, "examples", os.path.basename(example))
    shutil.copytree(example, work, ignore=shutil.ignore_patterns("picture.svg"))
    os.symlink(os.path.join(sources, "robots"), os.path.join(folder, "robots"))
    faults = faults_of("README.md", blocks, prose, sources, [])
    promised = [line for kind, _, code in blocks if kind == "text" for line in code.splitlines()]
    if "](picture.svg)" not in page or not promised:
        faults.append("the page shows no picture, or nothing of what its commands print")
    if not faults:
        printed, status = do_as_it_says(blocks, work, environment)
        faults = [f"exit {status}"] if status else compare_picture(example, work)
        faults += [f"not printed: {line}" for line in promised if line not in printed]
    print(*faults, sep="\n")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
