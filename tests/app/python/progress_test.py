"""Functions tell how far they are, can be pickled, and answer Ctrl+C at once."""

import contextlib
import io
import multiprocessing
import os
import pathlib
import pickle
import signal
import subprocess
import sys
import tempfile
import threading
import time
import types
import unittest
import unittest.mock
import warnings

import numpy as np
import tactspace
from places import four, twelve

WAVES = np.random.default_rng(1).normal(size=(60, 8000))


class Told(unittest.TestCase):
    def test_a_function_is_told_the_share_of_the_work(self):
        told = []
        thread = []

        def progress(share, text):
            told.append((share, text))
            thread.append(threading.current_thread())

        matrix = tactspace.predict(WAVES, progress=progress)
        np.testing.assert_array_equal(matrix, tactspace.predict(WAVES))
        shares = [share for share, _ in told]
        self.assertEqual(shares, sorted(shares))
        self.assertEqual(told[-1], (1.0, "comparing pairs"))
        self.assertEqual(set(thread), {threading.current_thread()})

    def test_what_it_raises_ends_the_work(self):
        def progress(share, text):
            raise LookupError(text)

        began = time.monotonic()
        with self.assertRaisesRegex(LookupError, "comparing pairs"):
            tactspace.predict(np.random.default_rng(1).normal(size=(700, 20000)), progress=progress)
        self.assertLess(time.monotonic() - began, 60.0)  # of hours

    def test_every_long_function_tells(self):
        given = tactspace.read_set(four)
        square = tactspace.predict(given["waves"])
        with warnings.catch_warnings(), tempfile.TemporaryDirectory() as folder:
            warnings.simplefilter("ignore")
            for name, arguments in {
                "predict": [given["waves"]], "subset": [square, 4], "space": [square], "compare": [square, square],
                "paper": [[dict(given, ratings=square)]], "plan": [square, square, [3]],
                "train": [[dict(given, ratings=square)]], "separate": [given, (0, 1)], "steps": [given, 0, 1],
                "groups": [given], "export": [given, folder, "ahap"], "report": [given],
            }.items():
                told = []
                getattr(tactspace, name)(*arguments, progress=lambda share, text: told.append(share))
                with self.subTest(name):
                    self.assertTrue(told)
                    self.assertTrue(all(0.0 <= share <= 1.0 for share in told))

    def test_true_draws_a_line_that_is_gone_afterwards(self):
        said = io.StringIO()
        with contextlib.redirect_stderr(said):
            tactspace.predict(WAVES, progress=True)
            tactspace.predict(WAVES, progress=False)
        self.assertIn("comparing pairs [#", said.getvalue())
        self.assertTrue(said.getvalue().endswith("\r\x1b[K"))

    def test_true_draws_a_bar_in_a_notebook(self):
        drawn = []

        class Handle:
            def update(self, html):
                drawn.append(html)

        def display(html, display_id):
            drawn.append(html)
            return Handle()

        ipython = types.ModuleType("IPython")
        ipython.get_ipython = lambda: types.SimpleNamespace(kernel=True)
        shown = types.ModuleType("IPython.display")
        shown.HTML, shown.display = str, display
        said = io.StringIO()
        with unittest.mock.patch.dict(sys.modules, {"IPython": ipython, "IPython.display": shown}):
            with contextlib.redirect_stderr(said):
                tactspace.predict(WAVES, progress=True)
        self.assertEqual(said.getvalue(), "")
        self.assertEqual(drawn[-1], '<progress max="100" value="100"></progress> comparing pairs, 100 %')


class Pickled(unittest.TestCase):
    def test_every_function_comes_back_as_itself(self):
        for name, function in vars(tactspace).items():
            if callable(function) and not name.startswith("_"):
                self.assertIs(pickle.loads(pickle.dumps(function)), function)

    def test_processes_share_the_work(self):
        patterns = tactspace.read_set(twelve)["patterns"][:4]
        with multiprocessing.get_context("spawn").Pool(2) as pool:
            waves = pool.map(tactspace.render, patterns)
        for wave, pattern in zip(waves, patterns):
            np.testing.assert_array_equal(wave, tactspace.render(pattern))


# Prints how long after the signal the interpreter has its line back.
INTERRUPTED = """
import os, signal, sys, threading, time, warnings
import numpy as np, tactspace
warnings.simplefilter("ignore")
signal.signal(signal.SIGINT, signal.default_int_handler)
rng = np.random.default_rng(4)
square = rng.uniform(1.0, 2.0, 150 * 149 // 2)
ratings = dict(names=[str(k) for k in range(150)], participants=[str(k) for k in range(20)],
               ratings=rng.uniform(1.0, 2.0, (20, 150 * 149 // 2)))
long = rng.normal(size=(150, 20000))
calls = {
    "render": lambda: tactspace.render({"duration_s": 60, "carriers": [{"frequency_hz": 100}]}, 1e6),
    "compare": lambda: tactspace.compare(square, ratings),
    "predict": lambda: tactspace.predict(long, "dtw"),
    "paper": lambda: tactspace.paper([dict(waves=long, ratings=ratings)]),
    "stages": lambda: tactspace.stages(rng.normal(size=600000)),
    "space": lambda: tactspace.space(rng.uniform(1.0, 2.0, 2000 * 1999 // 2)),
    "subset": lambda: tactspace.subset(rng.uniform(1.0, 2.0, 3000 * 2999 // 2), 12, objective="max-sum"),
    "unfelt": lambda: tactspace.unfelt(rng.normal(size=(40, 100000))),
}
sent = None
def send():
    global sent
    time.sleep(1.0)
    sent = time.monotonic()
    os.kill(os.getpid(), signal.SIGINT)
threading.Thread(target=send, daemon=True).start()
try:
    calls[sys.argv[1]]()
    print("ended")
except KeyboardInterrupt:
    print(time.monotonic() - sent)
sys.stdout.flush()
os._exit(0)
"""


class Interrupted(unittest.TestCase):
    def test_ctrl_c_is_answered_within_half_a_second(self):
        for name in ("render", "compare", "predict", "paper", "stages", "space", "subset", "unfelt"):
            with self.subTest(name):
                done = subprocess.run([sys.executable, "-c", INTERRUPTED, name], capture_output=True, text=True)
                self.assertEqual(done.stderr, "")
                if done.stdout != "ended\n":  # a machine may be too fast to be interrupted
                    self.assertLess(float(done.stdout), 0.5)

    def test_the_interpreter_ends_once_what_was_left_alone_has(self):
        program = INTERRUPTED.replace("os._exit(0)\n", "")
        done = subprocess.run([sys.executable, "-c", program, "render"], capture_output=True, text=True)
        self.assertEqual((done.returncode, done.stderr), (0, ""))


if __name__ == "__main__":
    unittest.main()
