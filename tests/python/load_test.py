"""Would catch: a module with other functions, numbers or bits than the program's package, a module of another scene or
robot than was asked for, and results that other processes cannot read."""

import multiprocessing
import os
import pickle
import unittest
from importlib.metadata import version
from pathlib import Path

import numpy as np
import ur10e
from own_cache import ROBOTS, OwnCacheTest

import treeline


def first_rows(result):
    """In another process, which has to find the type of what it is given."""
    return type(result).__module__, [np.asarray(each)[:1].tolist() for each in result]


class LoadTest(OwnCacheTest):
    def test_bits_are_those_of_what_pip_builds(self):
        arm = treeline.load(ROBOTS / "ur10e" / "ur10e.urdf", ROBOTS / "ur10e" / "scene.yaml")
        names = sorted(name for name, member in vars(ur10e).items() if type(member).__name__ == "builtin_function_or_method")
        self.assertGreater(len(names), 8)
        self.assertEqual(arm.digest, ur10e.digest)
        random = np.random.default_rng(20261129)
        sizes = {"xdd_cmd": arm.task_rows}
        for name in names:
            with self.subTest(function=name):
                symbols = getattr(ur10e, name).__text_signature__.split("(")[1].split(", *")[0].split(", ")[1:]
                values = {symbol: random.uniform(-2, 2, (50, sizes.get(symbol, arm.nv))) for symbol in symbols}
                results, expected = getattr(arm, name)(**values), getattr(ur10e, name)(**values)
                for one, other in zip(as_list(results), as_list(expected), strict=True):
                    self.assertEqual(one.tobytes(), other.tobytes())

    def test_physics_of_a_pendulum(self):
        """m g r at rest, of the mass in the file: a stale module would have another."""
        for mass in (2, 3, 2):
            self.write_arm(mass)
            arm = treeline.load("arm.urdf")
            # A rounding of each of the three factors.
            self.assertAlmostEqual(abs(arm.gravity(np.zeros(1))[0]), mass * 9.81 * 0.2, delta=1e-14)
        self.assertEqual(len(self.entries()), 2)

    def test_options_and_scenes_give_other_modules(self):
        points = {"operational_points": [{"name": "tip", "link": "forearm", "rows": ["z"],
                                           "origin": {"xyz": np.array([0.4, 0, 0])}}]}
        plain = treeline.load("arm.urdf")
        single = treeline.load(Path("arm.urdf"), real="float")
        fewer = treeline.load("arm.urdf", functions=["gravity", "mass_matrix"])
        scened = treeline.load("arm.urdf", points)
        floating = treeline.load("arm.urdf", {"base": "floating"}, functions=["gravity"])
        self.assertEqual(len({plain, single, fewer, scened, floating}), 5)
        self.assertEqual((plain.dtype, single.dtype), ("float64", "float32"))
        self.assertEqual(single.gravity(np.zeros(1, "float32")).dtype, np.float32)
        self.assertTrue(hasattr(plain, "inverse_dynamics") and not hasattr(fewer, "inverse_dynamics"))
        self.assertEqual(scened.forward_kinematics(np.zeros(1)).position.tolist(), [0.4, 0, 0])
        self.assertEqual((plain.nv, floating.nv, floating.nq), (1, 7, 8))

    def test_a_scene_in_a_file_and_as_a_dictionary(self):
        Path("scene.yaml").write_text("name: lever\ngravity: [0, 0, -1]\n", encoding="utf-8")
        of_file = treeline.load("arm.urdf", "scene.yaml")
        of_dictionary = treeline.load("arm.urdf", {"name": "lever", "gravity": [0, 0, -1.0]})
        self.assertEqual(of_file.gravity(np.zeros(1)), of_dictionary.gravity(np.zeros(1)))
        Path("scene.yaml").write_text("name: lever\ngravity: [0, 0, -2]\n", encoding="utf-8")
        heavier = treeline.load("arm.urdf", "scene.yaml")
        self.assertEqual(heavier.gravity(np.zeros(1)), 2 * of_file.gravity(np.zeros(1)))
        self.assertIs(treeline.load("arm.urdf", "scene.yaml"), heavier)

    def test_robots_that_a_scene_lists(self):
        """They are files that nobody names to `load`: a change, or the same scene elsewhere, is another module."""
        scene = "robots:\n  - {name: left, urdf: sub/one arm.urdf}\n  - {name: right, urdf: sub/one arm.urdf}\n"
        for folder, mass in (("a", 2), ("b", 3)):
            Path(folder, "sub").mkdir(parents=True)
            Path(folder, "two.yaml").write_text(scene, encoding="utf-8")
            self.write_arm(mass, f"{folder}/sub/one arm.urdf")
        weights = []
        for folder in ("a", "b", "a"):
            weights.append(abs(treeline.load(f"{folder}/two.yaml", functions=["gravity"]).gravity(np.zeros(2))).sum())
        self.write_arm(5, "a/sub/one arm.urdf")
        weights.append(abs(treeline.load("a/two.yaml", functions=["gravity"]).gravity(np.zeros(2))).sum())
        np.testing.assert_allclose(weights, 2 * 9.81 * 0.2 * np.array([2, 3, 2, 5]), rtol=1e-14)
        self.assertEqual(len(self.entries()), 3)

    def test_results_go_to_other_processes(self):
        arm = treeline.load("arm.urdf", {"operational_points": [{"name": "tip", "link": "forearm", "rows": ["z"]}]})
        pose = arm.forward_kinematics(np.zeros((3, 1)))
        self.assertIs(pickle.loads(pickle.dumps(arm.gravity)), arm.gravity)
        with multiprocessing.get_context("spawn").Pool(1) as pool:
            module, rows = pool.apply(first_rows, (pose,))
        self.assertEqual((module, rows), (arm.__name__, [np.asarray(each)[:1].tolist() for each in pose]))

    def test_numpy_is_not_needed_to_load(self):
        self.assertEqual(self.run_python("import sys; sys.modules['numpy'] = None\nimport array, treeline\n"
                                         "g = array.array('d', [0])\n"
                                         "treeline.load('arm.urdf').gravity(array.array('d', [0]), out=g)\n"
                                         "print(g[0] != 0)"), "True\n")

    def test_version_is_that_of_the_program(self):
        self.assertEqual(version("treeline"), os.environ["VERSION"])


def as_list(results):
    return list(results) if isinstance(results, tuple) else [results]


if __name__ == "__main__":
    unittest.main()
