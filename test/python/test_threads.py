# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026, the pcl_indoor contributors
import signal
import threading
import time
import unittest
from concurrent.futures import ThreadPoolExecutor

import numpy as np

import flat
import pcl_indoor


class Threads(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.points = flat.points()

    def test_python_goes_on_while_the_library_works(self):
        with ThreadPoolExecutor(1) as pool:
            work = pool.submit(pcl_indoor.segment_rooms, self.points, threads=1)
            steps = 0
            while not work.done():
                steps += 1
                time.sleep(0.001)
        self.assertGreater(steps, 20)

    def test_several_at_the_same_time_find_the_same(self):
        rooms = pcl_indoor.segment_rooms(self.points)
        scene = pcl_indoor.describe(self.points, messages=[]).to_dict()

        def refuse(k):
            with self.assertRaises(pcl_indoor.InputError) as caught:
                pcl_indoor.segment_rooms(np.full((k + 2, 3), np.nan))
            return str(caught.exception)

        with ThreadPoolExecutor(4) as pool:
            scenes = [pool.submit(pcl_indoor.describe, self.points, messages=[]) for _ in range(2)]
            labels = [pool.submit(pcl_indoor.segment_rooms, self.points) for _ in range(6)]
            errors = [pool.submit(refuse, k) for k in range(20)]
        for one in scenes:
            self.assertEqual(one.result().to_dict(), scene)
        for one in labels:
            np.testing.assert_array_equal(one.result(), rooms)
        for k, one in enumerate(errors):
            self.assertIn(f"none of its {k + 2} points is finite", one.result())

    def test_progress_may_come_from_any_thread(self):
        names = set()
        pcl_indoor.describe(
            self.points,
            messages=[],
            progress=lambda *step: names.add(threading.current_thread().name),
        )
        self.assertTrue(names)

    def test_ctrl_c_ends_the_work(self):
        def interrupt(stage, done, of):
            signal.raise_signal(signal.SIGINT)

        with self.assertRaises(KeyboardInterrupt):
            pcl_indoor.describe(self.points, messages=[], progress=interrupt)


if __name__ == "__main__":
    unittest.main()
