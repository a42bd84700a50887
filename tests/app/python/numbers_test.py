"""Numbers of patterns end in Python where they end in files, and are refused by the same sentence."""

import json
import pathlib
import re
import subprocess
import tempfile
import unittest

import tactspace
from places import program

# Places of every kind, each with a number that no pattern can have; the ranges are the program's to tell.
FULL = {"carriers": [{}], "rhythm": {"text": "A-", "notes": {"A": {}}}, "modulation": {"kind": "am"},
        "transients": [{"time_s": 0}], "amplitude_curve": [{"time_s": 0, "value": 1}],
        "frequency_curve": [{"time_s": 0, "frequency_hz": 150}]}
PLACES = [("amplitude_g",), ("carriers", 0, "frequency_hz"), ("carriers", 0, "weight"), ("carriers", 0, "phase_rad"),
          ("modulation", "frequency_hz"), ("modulation", "depth"), ("rhythm", "unit_s"), ("rhythm", "steps_a_beat"),
          ("rhythm", "beats_a_bar"), ("rhythm", "notes", "A", "velocity"), ("rhythm", "notes", "A", "pitch"),
          ("attack_s",), ("release_s",), ("duration_s",), ("amplitude_curve", 0, "value"),
          ("frequency_curve", 0, "frequency_hz"), ("transients", 0, "amplitude_g"),
          ("transients", 0, "frequency_hz"), ("transients", 0, "duration_s")]


def with_number(place, value):
    pattern = json.loads(json.dumps(FULL))
    part = pattern
    for key in place[:-1]:
        part = part[key]
    part[place[-1]] = value
    return pattern


class Numbers(unittest.TestCase):
    def by_file(self, pattern):
        """What the program says of a set with the pattern; empty: it reads it."""
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder) / "one.tactspace.json"
            file.write_text(json.dumps({"tactspace": 1, "name": "one",
                                        "patterns": [{"name": "a", **pattern}]}))
            done = subprocess.run([program, "predict", str(file)], capture_output=True, text=True)
        return done.stderr

    def by_python(self, pattern):
        try:
            tactspace.edit(pattern, ["reverse"])
        except ValueError as refused:
            return str(refused)
        return ""

    def test_each_ends_where_it_ends_in_files(self):
        for place in PLACES:
            for far in (-1e9, 1e9):
                with self.subTest(place=place, far=far):
                    sentence = re.compile(r"expected a (?:whole )?number from (\S+) to (\S+), got \S+")
                    file = sentence.search(self.by_file(with_number(place, far)))
                    self.assertIsNotNone(file)
                    python = sentence.search(self.by_python(with_number(place, far)))
                    self.assertIsNotNone(python)
                    self.assertEqual(python.group(), file.group())
                    for end in file.groups():
                        self.assertIsNone(sentence.search(self.by_python(with_number(place, float(end)))))


if __name__ == "__main__":
    unittest.main()
