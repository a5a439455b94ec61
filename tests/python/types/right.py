"""What a user writes: mypy --strict has nothing to say."""

from pathlib import Path

import numpy as np

import treeline

arm = treeline.load(Path("arm.urdf"), {"gravity": [0, 0, -1]}, functions=["gravity"], real="float")
weight: float = arm.gravity(np.zeros(arm.nq))[0]
mass: float = treeline.inspect("arm.urdf")["mass"]
passed: bool = treeline.check("arm.urdf", "scene.yaml", states=10)["passed"]
names: list[str] = [line["function"] for line in treeline.bench("arm.urdf", quick=True)]
picture: str = treeline.draw("arm.urdf", q=[0.0, 1.0]).svg
with treeline.drive("arm.urdf", browser=False, port=0) as robot:
    address: str = robot.url
try:
    treeline.load("arm.urdf")
except treeline.Error as error:
    place: tuple[str, int, str, str] = (error.file, error.line, error.place, error.advice)
    texts: list[str] = [each.text for each in error.diagnostics]
