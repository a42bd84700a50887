"""A virtual environment takes the package without a network, in both ways that the manual tells."""

import pathlib
import subprocess
import sys
import tempfile
import unittest

import numpy
import tactspace

PLACE = pathlib.Path(tactspace.__file__).parents[1]
SAYS = "import sys, tactspace; print(sys.prefix, tactspace.__version__)"


class Environment(unittest.TestCase):
    def made(self, *options):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        place = pathlib.Path(folder.name).resolve()
        subprocess.run([sys.executable, "-m", "venv", "--without-pip", *options, place], check=True)
        return place

    def imports(self, place):
        done = subprocess.run([place / "bin/python", "-c", SAYS], capture_output=True, text=True, env={})
        self.assertEqual(done.stderr, "")
        self.assertEqual(done.stdout.split(), [str(place), tactspace.__version__])

    def test_one_that_sees_the_system_and_a_line_that_names_the_folder(self):
        place = self.made("--system-site-packages")
        site = next(place.glob("lib/python3.*/site-packages"))
        (site / "tactspace.pth").write_text(f"{PLACE}\n")
        self.imports(place)

    def test_one_by_itself_that_has_its_own_numpy(self):
        place = self.made()
        site = next(place.glob("lib/python3.*/site-packages"))
        (site / "tactspace.pth").write_text(f"{PLACE}\n")
        (site / "numpy").symlink_to(pathlib.Path(numpy.__file__).parent)
        self.imports(place)


if __name__ == "__main__":
    unittest.main()
