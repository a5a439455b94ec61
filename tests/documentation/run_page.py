#!/usr/bin/env python3
"""Does what a page says, in an empty folder: writes the files that it shows and runs its commands, in its order.

Usage: run_page.py PAGE SOURCES PREFIX FOLDER [FILE]. PREFIX has an installed treeline; the caller uses FILE. Code of a
page is in fenced blocks:

  sh                       commands; each must succeed
  any, title="FILE"        a file, which a later block of the page has to name
  any, title="part of F"   lines of the file F of the sources
  text                     without a title: what a program prints, or an equation
  console                  commands of docs/start/install.md alone, which other tests run

Would catch: a command that fails, a file that does not do what the page says, code that nothing runs, and code that is
not in such a block.
"""

import os
import re
import shutil
import subprocess
import sys

FENCE = re.compile(r'^```(?P<kind>[a-z+]*)(?: title="(?P<title>[^"]*)")?\n(?P<code>(?:.*\n)*?)```$', re.M)


def blocks_of(text):
    """Kind, title and code of every fenced block, and what is between them."""
    return [(match["kind"], match["title"] or "", match["code"]) for match in FENCE.finditer(text)], FENCE.sub("", text)


def faults_of(page, blocks, prose, sources, used):
    """What the page shows and nothing would run."""
    faults = [f"code that is not in a block: {line}" for line in re.findall(r"^\n(?:    +| *```)(.*)$", prose, re.M)]
    for index, (kind, title, code) in enumerate(blocks):
        first = code.split("\n", 1)[0]
        if title.startswith("part of "):
            with open(os.path.join(sources, title.removeprefix("part of ")), encoding="utf-8") as file:
                if code not in file.read():
                    faults.append(f"lines that {title.removeprefix('part of ')} does not have: {first}")
        elif title:
            later = "\n".join(code for _, _, code in blocks[index + 1:])
            name = "cmake -S ." if title == "CMakeLists.txt" else title
            if name not in later and title not in used:
                faults.append(f"a file that nothing uses: {title}")
        elif kind not in ("sh", "text") and not (kind == "console" and page.endswith("start/install.md")):
            faults.append(f"a block that nothing runs: {kind or 'without a language'}: {first}")
    return faults


def environment_in(folder, sources, prefix):
    """Empties the folder; the environment of somebody whose home is in it and has an installed treeline."""
    shutil.rmtree(folder, ignore_errors=True)
    os.makedirs(os.path.join(folder, "home"))
    os.symlink(prefix, os.path.join(folder, "home", ".local"))
    return dict(os.environ, HOME=os.path.join(folder, "home"), TREELINE=sources,
                PATH=os.path.join(prefix, "bin") + os.pathsep + os.environ["PATH"])


def run(blocks, sources, prefix, folder):
    """Writes the files and runs the commands; returns the exit status."""
    environment = environment_in(folder, sources, prefix)
    work = os.path.join(folder, "work")
    os.makedirs(work)
    for kind, title, code in blocks:
        if title and not title.startswith("part of "):
            with open(os.path.join(work, title), "w", encoding="utf-8") as file:
                file.write(code)
        elif kind == "sh":
            # A busy machine may miss the deadlines of real time; a loop then stops, as it should.
            commands = re.sub(r" --realtime$", r" --realtime || true", code, flags=re.M)
            if status := subprocess.run(["bash", "-euxo", "pipefail", "-c", commands], cwd=work, env=environment,
                                        check=False).returncode:
                return status
    return 0


def main():
    page, sources, prefix, folder = (os.path.abspath(path) for path in sys.argv[1:5])
    with open(page, encoding="utf-8") as file:
        blocks, prose = blocks_of(file.read())
    if faults := faults_of(page, blocks, prose, sources, sys.argv[5:]):
        print(*faults, sep="\n")
        return 1
    return run(blocks, sources, prefix, folder)


if __name__ == "__main__":
    sys.exit(main())
