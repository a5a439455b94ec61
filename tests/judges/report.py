"""What came of judging: errors, what could not be compared, and whether the tables say so."""

import collections
import fnmatch
import re

# Relative to the terms of each result. All four programs round at 1e-16 and lose digits by the condition of the
# mass matrix and of the task's, which is up to 1e6 here: agreement is 1e-12 or better in what is not solved for.
TOLERANCE = 1e-9


class Report:
    """The worst error of each function by judge, and what could not be compared."""

    def __init__(self, table):
        self.errors = collections.defaultdict(float)
        self.reasons = {}
        self.had, self.lacking, self.left_out = set(), set(), {}
        self.known = []
        with open(table, encoding="utf-8") as file:
            for line in file.read().splitlines()[1:]:
                case, figure, judge, reason = line.split("\t")
                self.known.append((case, figure, judge, reason))

    def note(self, case, figure, judge, error):
        key = (case, figure, judge)
        self.errors[key] = error if not error <= self.errors[key] else self.errors[key]

    def skip(self, case, figure, judge, reason):
        self.reasons.setdefault((case, figure, judge), str(reason))

    def faults(self, cases):
        """What differs or was not compared without a row that says why, and rows that say what is not so."""
        found = {key: f"differs by {error:.2g} of its terms" for key, error in self.errors.items()
                 if not error <= TOLERANCE}
        found.update({key: "not compared: " + reason for key, reason in self.reasons.items() if key not in self.errors})
        met = set()
        for key, what in sorted(found.items()):
            rows = [row for row in self.known if all(map(fnmatch.fnmatchcase, key, row))]
            met.update(rows)
            if not rows:
                yield " ".join(key) + ": " + what
        for row in self.known:
            if row not in met and any(fnmatch.fnmatchcase(case, row[0]) for case in cases):
                yield " ".join(row[:3]) + ": agrees now; remove its row from disagreements.tsv"

    def faults_of_table(self, page):
        """What the page's table of functions and judges says that is not so."""
        with open(page, encoding="utf-8") as file:
            rows = dict(re.findall(r"^\| `(\w+)` \| (.*?) \|", file.read(), re.M))
        for function, judge in sorted(self.had | self.lacking):
            listed = judge in rows.get(function, "").lower().split(", ")
            if listed != ((function, judge) in self.had):
                yield f"{page}: {judge} {'lacks' if listed else 'judges'} {function}"

    def print_case(self, case, seconds):
        errors = {key: error for key, error in self.errors.items() if key[0] == case}
        compared = {figure for _, figure, _ in errors}
        for (name, figure), reason in self.left_out.items():
            if name == case and figure not in compared:
                print(f"{case}: {figure} left out: {reason}")
        if not errors:
            print(f"{case}: nothing compared, {seconds:.0f} s", flush=True)
            return
        worst = max(errors, key=errors.get)
        print(f"{case}: {len(errors)} figures, worst {errors[worst]:.1e} ({worst[1]}, {worst[2]}), {seconds:.0f} s",
              flush=True)
