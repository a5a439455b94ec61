"""Would catch: an interpreted function that differs from the compiled one in name, argument, shape or value, states of a
batch that are mixed up, and processes that stay behind."""

import gc
import os
import re
import subprocess
import threading
import unittest
import unittest.mock
import warnings
from pathlib import Path

import numpy as np
import ur10e
from own_cache import ROBOTS, OwnCacheTest

import treeline

SEED = 20261129
SCENE = ROBOTS / "ur10e" / "scene.yaml"
LOOSE = {"base": "floating", "functions": ["inverse_dynamics", "mass_matrix", "forward_dynamics", "center_of_mass"]}
TASK_SOLVES = {"lambda_", "control_torque", "damped_control_torque"}
SOLVED = 1e-7  # the condition number of Lambda^-1, up to 1e7 at these states, multiplies a hundred roundings


class ModelTest(OwnCacheTest):
    def model(self, *arguments, **options):
        model = treeline.Model(*arguments, **options)
        self.addCleanup(model.close)
        return model

    def assert_same(self, results, expected, tolerance):
        """Relative to the largest entry of the result of each state: what cancels in one entry is an error of others."""
        for one, other in zip(as_list(results), as_list(expected), strict=True):
            self.assertEqual((one.shape, one.dtype), (other.shape, other.dtype))
            size = np.abs(other).reshape(len(other), -1).max(axis=1).reshape(-1, *[1] * (other.ndim - 1))
            self.assertLess((np.abs(one - other) / size).max(), tolerance)

    def compare(self, model, compiled, tolerance, given=()):
        random = np.random.default_rng(SEED)
        listed = {name for name, member in vars(compiled).items() if type(member).__name__ == "builtin_function_or_method"}
        self.assertEqual(set(model.functions), listed)
        for name in sorted(listed):
            with self.subTest(function=name, seed=SEED):
                function = getattr(model, name)
                symbols = getattr(compiled, name).__text_signature__.split("(")[1].split(", *")[0].split(", ")[1:]
                self.assertEqual([each.name for each in function.arguments], symbols)
                values = {each.name: random.uniform(-2, 2, (30, each.size)) for each in function.arguments}
                values.update((each, value) for each, value in given if each in values)
                expected = getattr(compiled, name)(**values)
                self.assert_same(function(**values), expected, SOLVED if name in TASK_SOLVES else tolerance)
                self.assertEqual([each.name for each in function.results] if isinstance(expected, tuple) else [],
                                 list(type(expected).__match_args__) if isinstance(expected, tuple) else [])

    def test_functions_are_those_of_compiled_code(self):
        """Two formulations of the same equations in double: a hundred roundings."""
        self.compare(self.model(ROBOTS / "ur10e" / "ur10e.urdf", SCENE), ur10e, 1e-14)

    def test_a_floating_base(self):
        text = Path("arm.urdf").read_text(encoding="utf-8")
        inertial = text[text.index("<inertial>"):text.index("</inertial>")] + "</inertial>"
        Path("loose.urdf").write_text(text.replace('<link name="base"/>', f'<link name="base">{inertial}</link>'),
                                      encoding="utf-8")
        q = np.random.default_rng(SEED).uniform(-2, 2, (30, 8))
        q[:, 3:7] /= np.linalg.norm(q[:, 3:7], axis=1, keepdims=True)
        self.compare(self.model("loose.urdf", LOOSE), treeline.load("loose.urdf", LOOSE), 1e-14, [("q", q)])

    def test_every_function(self):
        """Of the generator's table: on some scene of the sources its results have the sizes that were told, and are
        finite."""
        table = Path(os.environ["SOURCES"], "generator", "functions", "function_rows.hpp").read_text(encoding="utf-8")
        missing = {name + "_" * (name == "lambda") for name in re.findall(r'{Function::\w+,\s*"(\w+)"', table)}
        self.assertGreater(len(missing), 40)
        random = np.random.default_rng(SEED)
        written = ROBOTS.parent / "tests" / "data" / "written"
        self.enterContext(warnings.catch_warnings())
        warnings.simplefilter("ignore", treeline.InputWarning)
        for scene in [*sorted(ROBOTS.glob("*/scene*.yaml")), *sorted(written.glob("*.yaml"))]:
            urdf = [*scene.parent.glob(f"{scene.stem if scene.parent == written else '*'}.urdf")]
            if not missing or len(urdf) != 1:
                continue
            for name in sorted(missing):
                try:
                    model = self.interpret(urdf[0], scene, name)
                except treeline.Error:  # the scene has not what it is about
                    continue
                with self.subTest(scene=scene, function=name, seed=SEED):
                    function = getattr(model, name)
                    values = [random.uniform(-1, 1, (3, each.size)) for each in function.arguments]
                    self.assertTrue(all(np.isfinite(result).all() for result in as_list(function(*values))))
                missing.discard(name)
        self.assertEqual(missing, set())

    def interpret(self, urdf, scene, name):
        """A model with a function; those that are composed are never asked for by their names."""
        if name == "damped_control_torque":
            model = self.model(urdf, scene)
            if name not in model.functions:
                raise treeline.Error("the scene has no key `damped`")
            return model
        return self.model(urdf, scene, functions=[name.removesuffix("_")])

    def test_all_functions_of_a_small_arm(self):
        urdf, scene = ROBOTS / "planar3r" / "planar3r.urdf", ROBOTS / "planar3r" / "scene.yaml"
        names = ["inverse_dynamics_derivatives", "forward_dynamics_derivatives", "coriolis_matrix", "energy_regressor",
                 "centroidal_momentum_rate_derivatives", "subtree_masses_and_centers", "point_acceleration_derivatives",
                 "dynamically_consistent_inverse", "null_space_projector", "operational_bias_force", "forward_kinematics",
                 "link_inverse_inertias", "inverse_dynamics_regressor"]
        self.compare(self.model(urdf, scene, functions=names), treeline.load(urdf, scene, functions=names), 1e-13)

    def test_names_and_limits(self):
        model = self.model(ROBOTS / "ur10e" / "ur10e.urdf", SCENE)
        for name in ("nq", "nv", "task_rows", "home", "lower_limits", "upper_limits", "coordinate_joints", "velocity_joints",
                     "coordinate_meanings", "velocity_names", "velocity_limits", "effort_limits", "dtype"):
            self.assertEqual(getattr(model, name), getattr(ur10e, name), name)
        self.assertIn("inverse_dynamics", dir(model))
        self.assertIn("joint accelerations", model.inverse_dynamics.__doc__)

    def test_physics_of_a_pendulum(self):
        model = self.model("arm.urdf")
        weight = np.array([model.gravity([angle])[0] for angle in (0, 1.0, np.pi / 2)])
        np.testing.assert_allclose(np.abs(weight), 2 * 9.81 * 0.2 * np.cos([0, 1, np.pi / 2]), atol=1e-15)
        self.assertAlmostEqual(model.mass_matrix(0.3).item(), 0.1 + 2 * 0.2**2, delta=1e-16)
        self.assertFalse(self.cache.exists())  # nothing is compiled

    def test_states_of_a_batch(self):
        """More than one request has, and more than a thread computes alone."""
        model = self.model("arm.urdf")
        q = np.random.default_rng(SEED).uniform(-2, 2, (1999, 1))
        singles = np.array([model.gravity(each) for each in q])
        with unittest.mock.patch("treeline._model.MOST_STATES", 300):
            self.assertEqual(model.gravity(q).tobytes(), singles.tobytes())
        self.assertEqual(model.gravity(q[::-1]).tobytes(), singles[::-1].tobytes())
        shared = model.inverse_dynamics(q, np.zeros(1), qdd=[[3.0]] * len(q))
        self.assertEqual(shared.tobytes(), model.inverse_dynamics(q, 0 * q, 3 + 0 * q).tobytes())
        self.assertEqual(model.gravity(q[:0]).shape, (0, 1))

    def test_refusals(self):
        model = self.model("arm.urdf")
        for call, fault, text in (
                (lambda: model.gravity([0, 0]), ValueError, r"q: has the shape \(2,\), wants \(1,\) or \(N, 1\)"),
                (lambda: model.inverse_dynamics(0), TypeError, "lacks the argument qd"),
                (lambda: model.gravity(0, 0), TypeError, "takes 1 arguments"),
                (lambda: model.gravity(0, q=0), TypeError, "given 'q' twice"),
                (lambda: model.gravity(p=0), TypeError, "no argument 'p'"),
                (lambda: model.gravity("one"), ValueError, "could not convert"),
                (lambda: model.inverse_dynamics(np.zeros((2, 1)), np.zeros((3, 1)), 0), ValueError, "qd: has 3 states"),
                (lambda: model.jacobian(0), AttributeError, "no function jacobian, but .*operational_points")):
            with self.assertRaisesRegex(fault, text):
                call()
        self.assertEqual(model.gravity(0.0).shape, (1,))  # it goes on
        with self.assertRaises(treeline.Error) as caught:
            treeline.Model("arm.urdf", {"gravty": 1})
        self.assertEqual((caught.exception.place, caught.exception.file), ("gravty", "standard input"))

    def test_messages(self):
        with self.assertLogs("treeline", "INFO") as told:
            model = self.model("arm.urdf", {"real": "float"})
        self.assertIn("standard input: note: real: the interpreter computes in double", "".join(told.output))
        self.assertEqual(model.gravity(0).dtype, np.float64)
        text = Path("arm.urdf").read_text(encoding="utf-8")
        Path("arm.urdf").write_text(text.replace('name="base"', 'name="base" colour="red"'), encoding="utf-8")
        with self.assertWarnsRegex(treeline.InputWarning, "colour"):
            self.model("arm.urdf")

    def test_threads(self):
        model = self.model("arm.urdf")
        angles = np.linspace(-1, 1, 40)
        expected = [model.gravity(angle).item() for angle in angles]
        found = {}
        threads = [threading.Thread(target=lambda i=i: found.update({i: model.gravity(angles[i]).item()}))
                   for i in range(len(angles))]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        self.assertEqual([found[i] for i in range(len(angles))], expected)

    def test_its_process_ends(self):
        with treeline.Model("arm.urdf") as model:
            first = model._conversation._process.pid
        with self.assertRaisesRegex(ValueError, "closed"):
            model.gravity(0)
        model = treeline.Model("arm.urdf")
        second = model._conversation._process
        del model
        gc.collect()
        for process in (first, second.pid):
            self.assertRaises(ProcessLookupError, os.kill, process, 0)
        output = self.run_python("import treeline; print(treeline.Model('arm.urdf')._conversation._process.pid)")
        self.assertRaises(ProcessLookupError, os.kill, int(output), 0)

    def test_a_process_that_was_killed(self):
        model = self.model("arm.urdf")
        model._conversation._process.kill()
        with self.assertRaisesRegex(treeline.Error, "ended with -9"):
            model.gravity(0)

    def test_requests_that_cannot_be_understood(self):
        for request in (b"call gravity many\n", b"call gravity 99999999999\n", b"describe nothing\n", b"\0\xff\n", b"\n",
                        b"call step 1 1e-3 1 true\n"):  # which was not described
            ran = subprocess.run([os.environ["TREELINE"], "interpret", "arm.urdf"], input=request, capture_output=True,
                                 check=False)
            self.assertEqual(ran.returncode, 1)
            self.assertIn(b"cannot be understood", ran.stdout.splitlines()[1])
        cut = subprocess.run([os.environ["TREELINE"], "interpret", "arm.urdf"], input=b"call gravity 2\n12345678",
                             capture_output=True, check=False)
        self.assertEqual((cut.returncode, len(cut.stdout.splitlines())), (1, 1))


def as_list(results):
    return list(results) if isinstance(results, tuple) else [results]


if __name__ == "__main__":
    unittest.main()
