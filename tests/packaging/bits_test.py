"""Would catch: arguments in another order than C's, shapes that differ from the contract, flags that change bits,
states of a batch that are mixed up, and threads that compute one state twice or not at all."""

import array
import functools
import unittest

import numpy as np
from robots import ROBOTS, Library, as_list, draw, python_name

SEED = 20261129


def of_each_function(test):
    """Runs a test for every function of every robot, with random numbers of its own."""
    @functools.wraps(test)
    def run(self):
        for robot in ROBOTS:
            library = Library(robot)
            self.assertGreaterEqual(len(library.functions), 6)
            for function in library.functions:
                with self.subTest(robot=robot.__name__, function=function, seed=SEED):
                    test(self, robot, library, function, getattr(robot, python_name(function)))
    return run


class BitsTest(unittest.TestCase):
    def assert_same_bits(self, results, expected):
        self.assertEqual(len(results), len(expected))
        for result, wanted in zip(results, expected):
            self.assertEqual(np.asarray(result).dtype, wanted.dtype)
            self.assertEqual(np.shape(result), wanted.shape)
            self.assertEqual(np.asarray(result).tobytes(), wanted.tobytes())
            self.assertTrue(np.isfinite(wanted).all())

    @of_each_function
    def test_results_are_those_of_c(self, robot, library, function, call):
        random = np.random.default_rng(SEED)
        for _ in range(20):
            values = draw(robot, library, function, random)
            expected = library.call(function, values)
            self.assert_same_bits(as_list(call(**values)), expected)
            self.assert_same_bits(as_list(call(*values.values())), expected)
            out = tuple(np.full_like(result, np.nan) for result in expected)
            given = call(**values, out=out if len(out) > 1 else out[0])
            self.assertTrue(all(one is other for one, other in zip(as_list(given), out)))
            self.assert_same_bits(out, expected)

    @of_each_function
    def test_batches_are_single_states(self, robot, library, function, call):
        random = np.random.default_rng(SEED)
        states = 1999  # enough operations for several threads
        values = draw(robot, library, function, random, states)
        singles = [as_list(call(**{name: rows[i] for name, rows in values.items()})) for i in range(states)]
        expected = [np.array(results) for results in zip(*singles)]
        self.assert_same_bits(as_list(call(**values)), expected)
        for threads in (2, 7, 1000):
            out = tuple(np.full_like(result, np.nan) for result in expected)
            call(**values, threads=threads, out=out if len(out) > 1 else out[0])
            self.assert_same_bits(out, expected)

    @of_each_function
    def test_arguments_without_n_hold_for_all_states(self, robot, library, function, call):
        random = np.random.default_rng(SEED)
        values = draw(robot, library, function, random, 9)
        for shared in values:
            mixed = {name: rows[0] if name == shared else rows for name, rows in values.items()}
            if len(mixed) == 1:
                continue
            repeated = {name: np.broadcast_to(rows[0], rows.shape) if name == shared else rows
                        for name, rows in values.items()}
            whole = {name: np.ascontiguousarray(rows) for name, rows in repeated.items()}
            expected = as_list(call(**whole))
            self.assert_same_bits(as_list(call(**mixed)), expected)
            self.assert_same_bits(as_list(call(**repeated)), expected)

    @of_each_function
    def test_arguments_lie_in_any_way(self, robot, library, function, call):
        random = np.random.default_rng(SEED)
        values = draw(robot, library, function, random, 6)
        expected = as_list(call(**values))
        for lay in (np.asfortranarray, with_gaps, backwards, off_alignment):
            laid = {name: lay(rows) for name, rows in values.items()}
            self.assertTrue(all((laid[name] == rows).all() for name, rows in values.items()))
            self.assert_same_bits(as_list(call(**laid)), expected)
        empty = call(**{name: rows[:0] for name, rows in values.items()})
        self.assertEqual([np.shape(result) for result in as_list(empty)], [(0, *np.shape(result)[1:]) for result in expected])

    @of_each_function
    def test_buffers_need_no_numpy(self, robot, library, function, call):
        random = np.random.default_rng(SEED)
        values = draw(robot, library, function, random)
        expected = library.call(function, values)
        code = "f" if robot.dtype == "float32" else "d"
        flat = {name: array.array(code, value.tobytes()) for name, value in values.items()}
        out = tuple(array.array(code, bytes(result.nbytes)) for result in expected)
        given = call(**flat, out=out if len(out) > 1 else out[0])
        for one, other, wanted in zip(as_list(given), out, expected):
            self.assertIs(one, other)
            self.assertEqual(one.tobytes(), wanted.tobytes())
        views = {name: memoryview(value.tobytes()).cast(code) for name, value in values.items()}
        self.assert_same_bits(as_list(call(**views)), expected)


def with_gaps(rows):
    laid = np.zeros((rows.shape[0], *(2 * n for n in rows.shape[1:])), rows.dtype)
    cut = laid[(slice(None), *(slice(None, None, 2) for _ in rows.shape[1:]))]
    cut[...] = rows
    return cut


def backwards(rows):
    turned = tuple(slice(None, None, -1) for _ in rows.shape)
    return np.ascontiguousarray(rows[turned])[turned]


def off_alignment(rows):
    room = np.zeros(rows.nbytes + 1, np.uint8)[1:]
    laid = room.view(rows.dtype).reshape(rows.shape)
    laid[...] = rows
    return laid


if __name__ == "__main__":
    unittest.main()
