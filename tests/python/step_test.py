"""Would catch: motions that are not those of `treeline simulate` or of physics, a ground, stops or forces that are left out,
states of a batch that are mixed up, and what cannot be moved and is moved all the same."""

import math
import unittest
from pathlib import Path

import numpy as np
from own_cache import OwnCacheTest

import treeline

BOX = """<robot name="box">
  <link name="box">
    <inertial><mass value="3"/><inertia ixx="0.02" ixy="0" ixz="0" iyy="0.02" iyz="0" izz="0.02"/></inertial>
    <collision><geometry><box size="0.2 0.2 0.2"/></geometry></collision>
  </link>
</robot>
"""
LOOSE = {"base": "floating", "ground": {"friction": 0.5}}
WEIGHT = 3 * 9.81


class StepTest(OwnCacheTest):
    def setUp(self):
        super().setUp()
        Path("box.urdf").write_text(BOX, encoding="utf-8")

    def model(self, *arguments):
        model = treeline.Model(*arguments)
        self.addCleanup(model.close)
        return model

    def at(self, height):
        return np.array([0, 0, height, 0, 0, 0, 1.0])

    def test_motions_are_those_of_the_simulation(self):
        """The same steps, printed with six digits less than they have."""
        model = self.model("arm.urdf")
        recorded = treeline.simulate("arm.urdf", q=[0.2], qd=[0.5], seconds=0.3, step=1e-3)
        q, qd, force, contacts = model.step([0.2], [0.5], [0.0], seconds=1e-3, steps=300)
        np.testing.assert_allclose([q[0], qd[0]], [recorded["q0"][-1], recorded["qd0"][-1]], rtol=1e-9)
        self.assertEqual((force.tolist(), contacts.tolist()), ([0, 0, 0], [0]))

    def test_a_constant_torque_raises_the_energy_by_its_work(self):
        model = self.model("arm.urdf", {"functions": ["kinetic_energy", "potential_energy"]})
        q, qd, *_ = model.step([0.0], [0.0], [1.5], seconds=1e-3, steps=200)
        energy = model.kinetic_energy(q, qd) + model.potential_energy(q) - model.potential_energy(0.0)
        self.assertAlmostEqual(energy.item(), 1.5 * q[0], delta=1e-10)  # Runge and Kutta err by the fifth power of the step

    def test_fall_rest_and_slide(self):
        model = self.model("box.urdf", LOOSE)
        rest, pushed = np.zeros(6), np.array([0.4 * WEIGHT, 0, 0, 0, 0, 0])
        fallen = model.step(self.at(5), rest, rest, seconds=1e-3, steps=500)
        self.assertAlmostEqual(fallen.q[2], 5 - 9.81 * 0.5**2 / 2, delta=1e-12)
        lies = model.step(self.at(0.1), rest, pushed, seconds=1e-3, steps=100)  # less than friction holds
        np.testing.assert_allclose(lies.q[:3], [0, 0, 0.1], atol=1e-9)
        np.testing.assert_allclose(lies.force, [-0.4 * WEIGHT, 0, WEIGHT], atol=1e-6)
        self.assertEqual(lies.contacts, [4])
        slides = model.step(self.at(0.1), np.array([2.0, 0, 0, 0, 0, 0]), rest, seconds=1e-3, steps=100)
        self.assertAlmostEqual(slides.qd[0], 2 - 0.5 * 9.81 * 0.1, delta=1e-6)
        falls = self.model("box.urdf", {"base": "floating"}).step(self.at(0.1), rest, rest, seconds=0.1)
        self.assertLess(falls.q[2], 0.06)  # where there is no ground

    def test_stops(self):
        model = self.model("arm.urdf")
        for stops, check in ((True, self.assertLessEqual), (False, self.assertGreater)):
            q, *_ = model.step([0.9], [3.0], [0.0], seconds=1e-3, steps=100, stops=stops)
            check(q[0], 1 + 1e-9)

    def test_states_of_a_batch(self):
        model = self.model("box.urdf", LOOSE)
        random = np.random.default_rng(20261130)
        q, qd, tau = random.normal(size=(30, 7)), random.normal(size=(30, 6)), random.normal(size=(30, 6))
        q[:, 3:] /= np.linalg.norm(q[:, 3:], axis=1, keepdims=True)
        together = model.step(q, qd, tau, seconds=2e-3, steps=20)
        for i in range(30):
            for one, many in zip(model.step(q[i], qd[i], tau[i], seconds=2e-3, steps=20), together):
                self.assertEqual(one.tobytes(), many[i].tobytes())

    def test_what_is_not_finite(self):
        model = self.model("arm.urdf")
        q, qd, *_ = model.step([[0.1], [math.nan], [0.1]], [0.0], [[0.0], [0.0], [math.inf]], seconds=1e-3)
        self.assertEqual(np.isfinite(np.hstack([q, qd])).tolist(), [[True, True], [False, False], [False, False]])

    def test_refusals(self):
        model = self.model("arm.urdf")
        for options in ({"seconds": 0}, {"seconds": -1}, {"seconds": math.inf}, {"seconds": math.nan},
                        {"seconds": 1e-3, "steps": 0}, {"seconds": 1e-3, "steps": 2**40}):
            with self.assertRaisesRegex(ValueError, "seconds: "):
                model.step([0], [0], [0], **options)
        with self.assertRaisesRegex(ValueError, r"tau: has the shape \(2,\)"):
            model.step([0], [0], [0, 0], seconds=1e-3)
        with self.assertRaises(TypeError):
            model.step([0], [0], [0], seconds=1e-3, steps=1.5)
        self.assertEqual(model.step([0], [0], [0], seconds=1e-3).q.shape, (1,))  # it goes on
        held = self.model("box.urdf", {"base": "floating", "constraints": [{"name": "held", "between": ["box", "world"]}]})
        for refused, text in ((held, "constraints"), (self.model("arm.urdf", {"ground": {}}), "no link that moves")):
            with self.assertRaisesRegex(treeline.Error, text):
                refused.step(*[np.zeros(n) for n in (refused.nq, refused.nv, refused.nv)], seconds=1e-3)


if __name__ == "__main__":
    unittest.main()
