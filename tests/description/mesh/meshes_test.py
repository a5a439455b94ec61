"""Meshes that trimesh writes, read and reduced by Treeline: volume, area and bounding box are those that trimesh measures.

Would catch: a corner that is read from the wrong byte, a face that is dropped or turned over, a node, a unit or an index
that is not obeyed, and a reduction that tears or shrinks a part.
"""
import os
import subprocess
import tempfile
import unittest
from pathlib import Path
from xml.etree import ElementTree

import numpy as np
import trimesh

PROGRAM = os.environ["MEASURE_MESHES"]


def shapes():
    """Closed surfaces: convex, with a hole, sharp, several in one, far from the origin."""
    far = trimesh.creation.icosphere(subdivisions=3, radius=0.3)
    far.apply_translation([5, -7, 11])
    lumps = trimesh.util.concatenate([trimesh.creation.capsule(height=1, radius=0.2),
                                      trimesh.creation.box((0.1, 2, 0.3), trimesh.transformations.random_rotation_matrix(
                                          np.array([0.1, 0.7, 0.4])))])
    return {"box": trimesh.creation.box((1, 2, 3)), "ring": trimesh.creation.annulus(0.5, 0.8, 0.4, sections=90),
            "cone": trimesh.creation.cone(0.3, 1.2, sections=64), "far": far, "lumps": lumps,
            "torus": trimesh.creation.torus(1, 0.25, major_sections=64, minor_sections=32)}


def measure(*arguments):
    lines = subprocess.run([PROGRAM, *map(str, arguments)], check=True, capture_output=True, text=True).stdout
    return [[float(word) for word in line.split()] for line in lines.splitlines()]


class Meshes(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)

    def compare(self, path, mesh, tolerance):
        """Tolerances are those of the digits in the file, relative to the size."""
        triangles, volume, area, *box = measure(path)[0]
        size = np.abs(mesh.bounds).max()
        self.assertEqual(triangles, len(mesh.faces), path)
        self.assertLess(abs(volume - mesh.volume), tolerance * size * mesh.area, path)
        self.assertLess(abs(area - mesh.area), tolerance * size * np.sqrt(triangles * mesh.area) + tolerance * mesh.area,
                        path)
        np.testing.assert_allclose(np.reshape(box, (2, 3)), mesh.bounds, rtol=0, atol=tolerance * size, err_msg=str(path))

    def test_every_format(self):
        for name, mesh in shapes().items():
            for kind, ending, tolerance in (("stl", "stl", 1e-7), ("stl_ascii", "STL", 1e-7), ("obj", "obj", 1e-7),
                                            ("dae", "dae", 1e-6)):
                path = self.folder / f"{name}_{kind}.{ending}"
                mesh.export(path, file_type=kind)
                with self.subTest(path.name):
                    self.compare(path, mesh, tolerance)

    def test_nodes_of_collada(self):
        """Parts with poses of their own, one of them a mirror image, whose arrays have the same names."""
        cone = trimesh.creation.cone(0.3, 1.2, sections=16)
        turn = trimesh.transformations.rotation_matrix(0.7, [1, 2, 3], [0.1, 0, 0])
        mirror = np.diag([1.0, -1, 1, 1])
        mirror[:3, 3] = 3, 2, 1
        box = trimesh.creation.box((1, 2, 3))
        document = ElementTree.fromstring(trimesh.exchange.dae.export_collada([cone, box, cone]))
        nodes = [element for element in document.iter() if element.tag.endswith("}node")]
        for node, pose in zip(nodes, (turn, np.eye(4), mirror), strict=True):
            matrix = ElementTree.Element(node.tag.replace("}node", "}matrix"))
            matrix.text = " ".join(map(repr, pose.flatten().tolist()))
            node.insert(0, matrix)
        path = self.folder / "parts.dae"
        path.write_bytes(ElementTree.tostring(document))
        self.compare(path, trimesh.util.concatenate([cone.copy().apply_transform(turn), box,
                                                     cone.copy().apply_transform(mirror)]), 1e-6)

    def test_reduced(self):
        """A hundred triangles are within 6 % of volume and area of these, and nothing is torn off."""
        for name, mesh in shapes().items():
            path = self.folder / f"{name}.stl"
            mesh.export(path)
            with self.subTest(name):
                triangles, volume, area, *box = measure("--most", 200, path)[0]
                self.assertLessEqual(triangles, 200)
                self.assertAlmostEqual(volume / mesh.volume, 1, delta=0.06)
                self.assertAlmostEqual(area / mesh.area, 1, delta=0.06)
                np.testing.assert_allclose(np.reshape(box, (2, 3)), mesh.bounds, rtol=0, atol=0.03 * mesh.scale)


if __name__ == "__main__":
    unittest.main()
