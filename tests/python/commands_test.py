"""Would catch: reports that are not the program's, options that do not reach it, and pictures that notebooks cannot
show."""

import json
import os
import subprocess
import unittest
import xml.etree.ElementTree
from pathlib import Path

import numpy as np
from own_cache import ROBOTS, OwnCacheTest

import treeline

PUMA = ROBOTS / "puma560" / "puma560.urdf"


def output_of(*arguments):
    """What the program writes to standard output."""
    return subprocess.run([os.environ["TREELINE"], *map(str, arguments)], capture_output=True, text=True, check=True).stdout


class CommandsTest(OwnCacheTest):
    def test_inspect(self):
        self.assertEqual(treeline.inspect(PUMA), json.loads(output_of("inspect", PUMA, "--json")))
        joints = treeline.inspect("arm.urdf", {"base": "floating"})["joints"]
        self.assertEqual([(joint["name"], joint["nv"]) for joint in joints][-1], ("elbow", 1))
        self.assertEqual(sum(joint["nv"] for joint in joints), 7)
        base = treeline.inspect("arm.urdf", base_parameters=True)
        self.assertEqual(base, json.loads(output_of("inspect", "arm.urdf", "--base-parameters", "--json")))

    def test_check(self):
        report = treeline.check("arm.urdf", functions=["gravity", "inverse_dynamics"], states=20, seed=3)
        self.assertIs(report["passed"], True)
        self.assertEqual(sorted(function["name"] for function in report["functions"]), ["gravity", "inverse_dynamics"])
        command = ["check", "arm.urdf", "--json", "--functions", "gravity,inverse_dynamics", "--states=20", "--seed=3"]
        told = json.loads(output_of(*command))
        self.assertEqual([function["worst"] for function in report["functions"]],
                         [function["worst"] for function in told["functions"]])

    def test_check_of_code_out_of_bounds(self):
        """Is a report and no error."""
        program = self.folder / "treeline"
        program.write_text('#!/bin/sh\necho \'{"passed": false}\'\nexit 3\n', encoding="utf-8")
        program.chmod(0o755)
        self.set_environment(TREELINE=str(program))
        self.assertEqual(treeline.check("arm.urdf"), {"passed": False})

    def test_bench(self):
        lines = treeline.bench("arm.urdf", functions=["gravity"], quick=True)
        self.assertGreater(len(lines), 1)
        self.assertTrue(all(isinstance(line, dict) for line in lines))
        self.assertIn("gravity", json.dumps(lines[1:]))

    def test_draw(self):
        drawing = treeline.draw(PUMA, q=np.array([0, -0.7, 0.7, 0, 0.5, 1e-20]), azimuth=0.5)
        self.assertEqual(drawing.svg, output_of("draw", PUMA, "--q", "0,-0.7,0.7,0,0.5,1e-20", "--azimuth=0.5"))
        self.assertNotEqual(drawing.svg, treeline.draw(PUMA).svg)
        self.assertEqual(drawing._repr_svg_(), drawing.svg)
        self.assertTrue(xml.etree.ElementTree.fromstring(drawing.svg).tag.endswith("svg"))
        drawing.save("puma.svg")
        self.assertEqual(Path("puma.svg").read_text(encoding="utf-8"), drawing.svg)

    def test_draw_a_motion(self):
        output_of("simulate", "arm.urdf", "--seconds=0.5", "--csv=-swing.csv")
        strip = treeline.draw("arm.urdf", motion="-swing.csv", times=[0, 0.25, 0.5])
        self.assertEqual(strip.svg.count(" s</text>"), 3)
        film = treeline.draw("arm.urdf", motion="-swing.csv", animate=True, seconds=1, fps=5)
        self.assertEqual(film.svg.count(" s</text>"), 6)


if __name__ == "__main__":
    unittest.main()
