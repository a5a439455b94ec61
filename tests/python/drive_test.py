"""Would catch: a page that does not open, commands that do not reach the robot, and processes that stay behind."""

import os
import signal
import time
import unittest
import urllib.request

from own_cache import OwnCacheTest

import treeline


class DriveTest(OwnCacheTest):
    def test_a_page_and_its_end(self):
        with treeline.drive("arm.urdf", {"gravity": [0, 0, -1]}, browser=False, port=0) as robot:
            process = robot._conversation._process.pid
            self.assertRegex(robot.url, r"^http://127\.0\.0\.1:\d+/\?token=\w+$")
            with urllib.request.urlopen(robot.url, timeout=30) as page:
                self.assertEqual(page.status, 200)
            robot.say("joint shoulder to 20 deg")
            deadline = time.monotonic() + 60
            while "shoulder" not in robot.messages() and time.monotonic() < deadline:
                time.sleep(0.01)
        self.assertIn("shoulder", robot.messages())  # which the robot has not
        self.assertRaises(ProcessLookupError, os.kill, process, 0)

    def test_its_end_where_interrupts_are_ignored(self):
        self.addCleanup(signal.signal, signal.SIGINT, signal.signal(signal.SIGINT, signal.SIG_IGN))  # as `script &` does
        with treeline.drive("arm.urdf", browser=False, port=0) as robot:
            process = robot._conversation._process.pid
        self.assertRaises(ProcessLookupError, os.kill, process, 0)

    def test_refusals(self):
        with self.assertRaises(treeline.Error) as caught:
            treeline.drive("arm.urdf", browser=False, rate=3)
        self.assertIn("--rate", str(caught.exception))


if __name__ == "__main__":
    unittest.main()
