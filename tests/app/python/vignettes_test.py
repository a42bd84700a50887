"""The vignettes run, and print what the program prints."""

import importlib.util
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest

import tactspace
from places import four, root, run, simulated_ratings

VIGNETTES = root / "assets/vignettes"


def has_reticulate():
    rscript = shutil.which("Rscript")
    asked = "quit(status = !requireNamespace('reticulate', quietly = TRUE))"
    return rscript is not None and subprocess.run([rscript, "-e", asked]).returncode == 0


class Vignettes(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        self.set = four
        self.ratings = simulated_ratings(self.set, folder.name)

    def holds(self, *command):
        """The command prints every row of Table 2 as the program does, that nobody was asked, and what
        to pick; what it printed."""
        environment = dict(os.environ, RETICULATE_PYTHON=sys.executable)
        done = subprocess.run([*map(str, command)], capture_output=True, text=True, env=environment)
        self.assertEqual(done.returncode, 0, done.stderr)
        lines = [line.split() for line in done.stdout.splitlines()]
        theirs = run("compare", self.set, "--ratings", self.ratings, "--paper-mode").splitlines()
        first = next(k for k, line in enumerate(theirs) if line.split() == ["metric", "rho", "K"])
        rows = [line.split() for line in theirs[first : first + 1 + len(tactspace.metrics)]]
        self.assertEqual([row[0] for row in rows[1:]], list(tactspace.metrics))
        begin = lines.index(rows[0])
        self.assertEqual(lines[begin : begin + len(rows)], rows)
        self.assertTrue(any(line[:1] == ["SYNTHETIC:"] for line in lines))
        picked = run("subset", self.set, "-k", 8).split("\n\n")[0].splitlines()
        words = next(line for line in done.stdout.splitlines() if line.startswith("most distinct: "))
        self.assertEqual(words.removeprefix("most distinct: ").strip(), ", ".join(picked))
        return done.stdout

    def test_python(self):
        picture = self.folder / "map.png"
        said = self.holds(sys.executable, VIGNETTES / "map_and_table.py", self.set, picture, self.ratings)
        if importlib.util.find_spec("matplotlib"):
            self.is_picture(picture)
        else:
            self.assertIn("no map is drawn: python3-matplotlib is not installed", said)

    @unittest.skipUnless(has_reticulate(), "R with r-cran-reticulate is not installed")
    def test_r(self):
        picture = self.folder / "map.png"
        self.holds("Rscript", VIGNETTES / "map_and_table.R", self.set, picture, self.ratings)
        self.is_picture(picture)

    def is_picture(self, file):
        self.assertEqual(file.read_bytes()[:8], b"\x89PNG\r\n\x1a\n")


if __name__ == "__main__":
    unittest.main()
