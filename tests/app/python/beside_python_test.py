"""Python continues while the model works, and stops it."""

import os
import signal
import subprocess
import sys
import threading
import unittest

import numpy as np
import tactspace

# Hours of work, in pieces of less than a second: what ends was stopped.
LONG = np.random.default_rng(1).normal(size=(700, 20000))


ENDS_WHILE_IT_WORKS = """
import threading, numpy as np, tactspace
waves = np.random.default_rng(1).normal(size=(700, 20000))
begun = threading.Event()
def work():
    begun.set()
    tactspace.predict(waves)
threading.Thread(target=work, daemon=True).start()
begun.wait()
for _ in range(200000): pass
"""


# Registered before the module, so called after it was told of the end.
WORKS_AT_THE_END = """
import atexit, numpy as np
def last():
    print(tactspace.predict(np.random.default_rng(1).normal(size=(3, 2000))).shape)
atexit.register(last)
import tactspace
"""


class BesidePython(unittest.TestCase):
    def test_an_interpreter_that_ends_leaves_a_daemons_work_in_peace(self):
        for _ in range(5):
            done = subprocess.run([sys.executable, "-c", ENDS_WHILE_IT_WORKS], capture_output=True, text=True)
            self.assertEqual((done.returncode, done.stderr), (0, ""))

    def test_what_ends_the_interpreter_may_still_work(self):
        done = subprocess.run([sys.executable, "-c", WORKS_AT_THE_END], capture_output=True, text=True)
        self.assertEqual((done.returncode, done.stdout, done.stderr), (0, "(3, 3)\n", ""))

    def setUp(self):
        # As in an interpreter that was started by hand; a background job ignores it.
        before = signal.signal(signal.SIGINT, signal.default_int_handler)
        self.addCleanup(signal.signal, signal.SIGINT, before)

    def stopped(self, work):
        """Runs work(), which a second thread interrupts once it has advanced; how far that came."""
        steps = 0
        begun = threading.Event()

        def advance():
            nonlocal steps
            begun.wait()
            while steps < 1000:
                steps += 1
            os.kill(os.getpid(), signal.SIGINT)

        other = threading.Thread(target=advance)
        other.start()
        try:
            begun.set()
            work()
            self.fail("the work came to its end before it was stopped")
        except KeyboardInterrupt:
            pass
        finally:
            other.join()
        return steps

    def test_a_second_thread_advances_and_ctrl_c_ends_a_prediction(self):
        for metric in ("pm", "dtw"):
            with self.subTest(metric):
                self.assertEqual(self.stopped(lambda: tactspace.predict(LONG, metric)), 1000)

    def test_ctrl_c_ends_a_search(self):
        distances = np.random.default_rng(2).uniform(1.0, 2.0, 200 * 199 // 2)
        for objective in ("max-min", "max-sum"):
            self.stopped(lambda: tactspace.subset(distances, 40, objective=objective, time_limit_s=1e9))

    def test_ctrl_c_ends_a_map(self):
        self.stopped(lambda: tactspace.space(np.random.default_rng(3).uniform(1.0, 2.0, 800 * 799 // 2)))

    def test_a_handler_that_raises_nothing_stops_nothing(self):
        caught = []
        signal.signal(signal.SIGINT, lambda *_: caught.append(True))
        threads = [threading.Thread(target=os.kill, args=(os.getpid(), signal.SIGINT))]
        threads[0].start()
        matrix = tactspace.predict(LONG[:4, :5000])
        threads[0].join()
        np.testing.assert_array_equal(matrix, tactspace.predict(LONG[:4, :5000]))
        self.assertTrue(caught)

    def test_threads_of_python_may_predict_at_once(self):
        expected = tactspace.predict(LONG[:4, :5000])
        results = []
        threads = [threading.Thread(target=lambda: results.append(tactspace.predict(LONG[:4, :5000])))
                   for _ in range(4)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        for result in results:
            np.testing.assert_array_equal(result, expected)
        self.assertEqual(len(results), 4)


if __name__ == "__main__":
    unittest.main()
