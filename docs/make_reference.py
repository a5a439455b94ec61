#!/usr/bin/env python3
"""Makes the pages of docs/reference that the program knows better than people: keys of scenes, functions, commands.

Usage: make_reference.py TREELINE [--compare]. With --compare nothing is written; a page that differs is named, and the
exit status is 3.
"""

import argparse
import json
import os
import re
import subprocess
import sys
import tempfile
import textwrap

DOCS = os.path.dirname(os.path.abspath(__file__))
SOURCES = os.path.dirname(DOCS)
HEAD = "<!-- Made by docs/make_reference.py: cmake --build BUILD -t report_reference -->\n"

GROUPS = {
    "robot": "Joints and the whole robot",
    "points": "Operational points",
    "center_of_mass": "Centre of mass and momentum",
    "derivatives": "Derivatives of inverse and forward dynamics",
    "constraints": "Constraints, and joints without a motor",
    "contacts": "Contacts",
    "links": "Links",
    "objects": "Objects in the hands",
}

# What most functions take, which the page says once.
ARGUMENTS = ("q: joint coordinates, rad", "qd: joint velocities, rad/s", "qdd: joint accelerations, rad/s^2",
             "qdd: joint accelerations", "tau: joint forces, N m", "tau: joint forces")

POINT = "operational_points: [{name: tool, link: tool}]\n"
# What a PUMA 560 needs in its scene so that functions of a group exist.
SCENES = {
    "robot": POINT + "damped: {mass: 100, inertia: 5}\ncontacts: [{name: palm, link: tool}]\n",
    "constraints": POINT + "constraints: [{name: hold, between: [link3, world], rows: [x, y, z]}]\npassive: [joint2]\n"
    "couplings: [{name: belt, joints: {joint5: 1, joint6: -1}}]\n",
    "objects": POINT + "objects:\n  - {name: box, mass: 4, inertia: {ixx: 0.05, iyy: 0.1, izz: 0.12},\n"
    "     grasps: [{point: tool}]}\n",
}


def call(*arguments):
    """Standard output of a program that has to succeed; what it says on standard error is shown."""
    return subprocess.run(arguments, check=True, stdout=subprocess.PIPE, text=True).stdout


def list_links(names):
    """Names of sections of the same page, as a paragraph."""
    return textwrap.fill(", ".join(f"[`{name}`](#{name})" for name in names), 120, break_long_words=False,
                         break_on_hyphens=False) + "\n"


def keys_page(treeline):
    keys = json.loads(call(treeline, "keys", "--json"))
    page = HEAD + (
        """# Keys of a scene

A scene is a YAML file. Every key is optional. An unknown key is an error that names the key you may have meant. Tags
such as `!degrees` are errors, for nothing here reads them. `treeline keys` prints what follows; links and joints in the
examples are those of a PUMA 560.

"""
    )
    page += list_links([key["name"] for key in keys])
    for key in keys:
        page += f"\n## {key['name']}\n\n{key['meaning']}"
        if key["page"]:
            page += f" [More]({os.path.relpath(key['page'], 'reference')})."
        page += f"\n\n- Value: {key['type']}.\n- Without it: {key['default']}.\n\n```yaml\n{key['example']}\n```\n"
    return page


def rows_of_functions():
    """Name, group and whether a scene has to ask, of every row of the program's table."""
    with open(os.path.join(SOURCES, "generator/functions/function_rows.hpp"), encoding="utf-8") as table:
        pattern = r'\{Function::\w+,\s*"(\w+)",\s*FunctionGroup::(\w+),\s*Emitted::(\w+)'
        return re.findall(pattern, table.read())


def declarations(treeline, scene, functions):
    """Comment and declaration of each function in the headers that the program writes."""
    with tempfile.TemporaryDirectory() as work:
        path = os.path.join(work, "scene.yaml")
        with open(path, "w", encoding="utf-8") as file:
            file.write("lanes: 1\n" + scene + (f"functions: [{', '.join(functions)}]\n" if functions else ""))
        urdf = os.path.join(SOURCES, "robots/puma560/puma560.urdf")
        call(treeline, "generate", urdf, path, "--output", os.path.join(work, "puma560"))
        text = ""
        for name in ("puma560.hpp", "puma560_damped.hpp"):
            if os.path.exists(header := os.path.join(work, "puma560", name)):
                with open(header, encoding="utf-8") as file:
                    text += file.read()
    found = re.findall(r"((?:^///.*\n)+)((?:inline )?(?:void|Real) (\w+)\((?:.|\n)*?\) noexcept)", text, re.M)
    return {name: (comment, declaration) for comment, declaration, name in found}


def function_text(name, emitted, comment, declaration):
    lines = re.sub(r"\n///(   | (?!Cost|Stack|Rounding|in |out |By ))", " ", comment).replace("/// ", "").splitlines()
    lines = [re.sub(r" +", " ", line) for line in lines]
    facts = [line for line in lines if not re.match(r"(Cost|Stack|Rounding|in |out |By )", line)]
    way = [line for line in lines if line.startswith("By ")]
    request = {"by_default": "", "on_request": " *On request.*", "with_damping": " *With the key `damped`.*"}[emitted]
    equation, _, rest = facts[0].partition(": that of ")
    rest = f" That of {rest}" if rest else ""
    plain = re.sub(r"\s=\s+\w+", "", declaration[declaration.index("("):])  # without defaults
    names = ", ".join(re.findall(r"\(?[&*]?(\w+)\)?(?:\[\d+\])?[,)]", plain))
    method = [re.split(r"; Lambda\^-1|, in (?:the|link) axes", line.rstrip("."))[0] + "." for line in way[:1]]
    text = f"\n### {name}\n\n`{equation}`{request}{rest}" + "".join(f" {line}" for line in method)
    text += f"\n\n`{name}({names})`\n"
    arguments = [match for line in lines if (match := re.match(r"(in|out) (\S+) \(([^)]*)\): (.*)", line))
                 and match[2] + ": " + match[4] not in ARGUMENTS]
    text += "\n" if arguments else ""
    for match in arguments:
        text += f"- {match[1]} `{match[2]}` ({match[3]}): {match[4]}\n"
    return text


def functions_page(treeline):
    rows = rows_of_functions()
    found = {}
    for group, scene in SCENES.items():
        own = [name for name, of, emitted in rows if emitted != "with_damping"
               and (of == group or group == "robot" and of not in ("constraints", "objects"))]
        found.update(declarations(treeline, scene, own))
    missing = [name for name, _, _ in rows if name not in found]
    if missing:
        sys.exit(f"no declaration of {', '.join(missing)}")
    page = HEAD + (
        """# Functions

Equations and algorithms are those that the program writes for a PUMA 560: six joints, one operational point of six
rows, one contact. Sizes, cost, rounding and algorithms of your robot stand in the header of its code. A scene has all
functions that its content permits, but those *on request* only if the key [`functions`](scene.md#functions) lists them.
With the keys [`inputs`](inputs.md), [`external_forces`](scene.md#external_forces) and [`sin_cos`](scene.md#sin_cos)
functions take more arguments. [What the equations do not say](../explanation/functions.md).

Results come last. A robot called `arm` is called so, `double` or `float`:

| language | call of `gravity(q, g)` |
|---|---|
| C++ | `arm::gravity(q, g);` arrays of their sizes, by reference |
| C | `arm_gravity(q, g);` pointers |
| Python | `g = arm.gravity(q)`, or `arm.gravity(q, out=g)` |

`limited_control_torque` with [limits](../explanation/limits.md) and `NAME_step` with a [controller](controller.md) have
headers of their own.

`q` are joint coordinates, rad or m; `qd`, `qdd` and `tau` joint velocities, accelerations and forces, unless listed as
something else.
"""
    )
    text = ""
    for group, title in GROUPS.items():
        page += f"\n{title}:\n" + list_links([name for name, of, _ in rows if of == group])
        text += f"\n## {title}\n"
        for name, of, emitted in rows:
            if of != group:
                continue
            text += function_text(name, emitted, *found[name])
    return page + text


def entries_of(help_text):
    """Arguments and options of a command's help, each with the lines that go on with it."""
    return re.findall(r"^  (?:-|[a-z]+ TEXT).*\n(?: {20,}.*\n)*", help_text, re.M)


def without_shared(help_text, shared):
    """The help with those names alone of what several commands have."""
    names = []
    for entry in entries_of(help_text):
        if entry in shared:
            help_text = help_text.replace(entry, "", 1)
            names.append(entry.split()[0].split(",")[-1].split("=")[0])
    names = ", ".join(name for name in names if name.startswith("-"))
    help_text = help_text[help_text.index("Usage: "):]  # behind what the table of commands says
    return re.sub(r"^Positionals:\n\n", "", help_text.replace("Options:\n", f"Options, with {names}:\n"), flags=re.M)


def commands_page(treeline):
    help_text = call(treeline, "--help")
    commands = re.findall(r"^  ([a-z-]+) +(\S.*)$", help_text[help_text.index("Subcommands:"):], re.M)
    page = HEAD + (
        """# Commands

`treeline help COMMAND` prints what stands here, with what [several commands](#of-several-commands) have, and which
options exclude each other. `-` as a file name is standard input, or standard output for what `init-scene`, `convert`,
`draw` and `simulate --csv` write. No command writes over a robot, scene or motion that it was given. SI units and
radians.

| command | does |
|---|---|
"""
    )
    for name, does in commands:
        page += f"| [`{name}`](#{name}) | {does} |\n"
    page += "\n| exit status | meaning |\n|---|---|\n"
    (codes,) = re.findall(r"^Exit: (.*)\.$", help_text, re.M)
    for code in codes.split(", "):
        page += "| {} | {} |\n".format(*code.split(" ", 1))
    helps = {name: re.sub(r" Excludes:( --[a-z-]+)+", "", call(treeline, "help", name)) for name, _ in commands}
    every = [entry for text in helps.values() for entry in entries_of(text)]
    shared = [entry for entry in dict.fromkeys(every) if every.count(entry) > 1]
    page += f"\n## Of several commands\n\n```text\n{''.join(shared)}```\n"
    for name, text in helps.items():
        page += f"\n## {name}\n\n```text\n{without_shared(text, shared).strip()}\n```\n"
    return page


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("treeline")
    parser.add_argument("--compare", action="store_true")
    given = parser.parse_args()
    stale = []
    for name, make in (("scene", keys_page), ("functions", functions_page), ("commands", commands_page)):
        path = os.path.join(DOCS, "reference", f"{name}.md")
        text = make(os.path.abspath(given.treeline))
        if given.compare:
            with open(path, encoding="utf-8") as file:
                stale += [path] if file.read() != text else []
        else:
            with open(path, "w", encoding="utf-8") as file:
                file.write(text)
    for path in stale:
        print(f"{path} is stale: cmake --build BUILD -t report_reference")
    return 3 if stale else 0


if __name__ == "__main__":
    sys.exit(main())
