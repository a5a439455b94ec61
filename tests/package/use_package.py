"""Uses the package of Python where it is installed: a compiled module, and the page. Usage: use_package.py URDF PROGRAM
Would catch another program than the one installed, one without its page, and headers that are not there."""

import os
import sys
import tempfile
import urllib.request
from array import array

import treeline

urdf, program = sys.argv[1:]
assert treeline._program.find_program() == program, treeline._program.find_program()
with tempfile.TemporaryDirectory() as cache:
    os.environ["TREELINE_CACHE"] = cache
    arm = treeline.load(urdf, {"gravity": [0, 0, -9.81]}, functions=["gravity"])
    torques = array("d", [0.0] * 6)
    arm.gravity(array("d", [0.0] * 6), out=torques)  # as NumPy is not there
    # The axis of the first joint of a UR5 is upright; the arm lies stretched beside it.
    assert abs(torques[0]) < 1e-12 and abs(torques[1]) > 50, list(torques)
    with treeline.drive(urdf, browser=False, port=0) as robot:
        with urllib.request.urlopen(robot.url, timeout=60) as page:
            text = page.read().decode()
    assert "<canvas" in text or "<script" in text, text
