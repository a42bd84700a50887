"""Sets are written as they were read, and exported, parted and filled as by the program."""

import json
import pathlib
import tempfile
import unittest
import warnings

import numpy as np
import tactspace
from places import four, root, run, run_json, sets, simulated_ratings, twelve


class Folder(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        silence = warnings.catch_warnings()
        silence.__enter__()
        self.addCleanup(silence.__exit__, None, None, None)
        warnings.simplefilter("ignore")


class Written(Folder):
    def test_every_bundled_set_comes_back_as_it_was(self):
        for path in [*sets, root / "assets/library/library.tactspace.json"]:
            with self.subTest(path.name):
                out = self.folder / path.name
                given = tactspace.read_set(path)
                tactspace.write_set(out, given)
                np.testing.assert_equal(self.plain(tactspace.read_set(out)), self.plain(given))

    def plain(self, given):
        return {key: value for key, value in given.items() if key != "remarks"}

    def test_what_was_changed_is_changed_and_the_rest_stays(self):
        file = self.folder / "mine.tactspace.json"
        document = json.loads(twelve.read_text())
        document["patterns"][1]["note"] = "as felt on Monday"
        file.write_text(json.dumps(document))
        given = tactspace.read_set(file)
        given["patterns"][0] = tactspace.edit(given["patterns"][0], ["reverse"])
        given["name"] = "Another"
        given["locked"] = [2]
        given["model"] = {"nc_weight": 0.9}
        tactspace.write_set(file, given)
        back = tactspace.read_set(file)
        self.assertEqual((back["name"], back["locked"], back["model"]), ("Another", [2], {"nc_weight": 0.9}))
        self.assertEqual(back["patterns"], given["patterns"])
        self.assertEqual(back["document"]["patterns"][1]["note"], "as felt on Monday")

    def test_a_set_by_hand_with_recordings_and_ratings(self):
        file = self.folder / "hand.tactspace.json"
        wave = np.sin(np.arange(5000) * 0.1)
        ratings = {"names": ["a", "b", "c"], "participants": ["p", "q"], "ratings": [[1.0, 2, 3], [3, 2, np.nan]]}
        tactspace.write_set(str(file), {"names": ["a", "b", "c"], "patterns": [{"amplitude_g": 0.5}, None, None],
                                        "waves": [None, wave, wave[:99]], "measures": ["", "a", ""],
                                        "synthetic": [False, True, False], "ratings": ratings})
        back = tactspace.read_set(file)
        np.testing.assert_allclose(back["waves"][1], wave, atol=1e-7)  # 32 bits
        self.assertEqual((back["measures"], back["synthetic"]), (["", "a", ""], [False, True, False]))
        np.testing.assert_array_equal(back["ratings"]["ratings"], ratings["ratings"])
        self.assertEqual(sorted(one.name for one in (self.folder / "measured").glob("*.wav")), ["b.wav", "c.wav"])

    def test_a_model_trained_on_what_nobody_said_stays_marked(self):
        file = self.folder / "trained.tactspace.json"
        given = tactspace.read_set(four)
        ratings = tactspace.read_ratings(simulated_ratings(four, self.folder), given["names"])
        model = tactspace.train([dict(given, ratings=ratings)], step=0.5)["model"]
        self.assertTrue(model["synthetic"])
        by_hand = {key: given[key] for key in ("names", "patterns")}
        for one in (given, by_hand):
            tactspace.write_set(file, dict(one, model=model, ratings=None))
            self.assertTrue(run_json("predict", file)["synthetic_model"])
            self.assertEqual(tactspace.read_set(file)["model"], model)

    def test_what_cannot_be_read_back_is_not_written(self):
        file = self.folder / "set.tactspace.json"
        file.write_text("before")
        for words, given in {"set: expected what read_set() gives; there is no \"names\"": {},
                             "a": {"names": ["a", "a"], "patterns": [{}, {}]},
                             'set["patterns"][0]: /amplitude_g: expected':
                                 {"names": ["a"], "patterns": [{"amplitude_g": -1}]},
                             'set["patterns"][0]: expected a pattern, or samples in set["waves"][0]':
                                 {"names": ["a"]},
                             'set["patterns"]: expected an element for each name, got 1':
                                 {"names": ["a", "b"], "patterns": [{}]}}.items():
            with self.subTest(words), self.assertRaises(ValueError) as caught:
                tactspace.write_set(file, given)
            self.assertIn(words, str(caught.exception))
        self.assertEqual(file.read_text(), "before")
        with self.assertRaisesRegex(TypeError, "set: expected a dict, got 3"):
            tactspace.write_set(file, 3)

    def test_effects_of_another_program_are_not_replaced(self):
        given = tactspace.read_set(twelve)
        tactspace.export(given, self.folder, "android-timings", given["names"][:1], loss=False)
        effect = next(self.folder.glob("*.json"))
        before = effect.read_bytes()
        with self.assertRaisesRegex(ValueError, "holds effects of another program"):
            tactspace.write_set(effect, tactspace.read_set(effect))
        with self.assertRaisesRegex(ValueError, "ends in .json"):
            tactspace.write_set(self.folder / "set.ahap", given)
        self.assertEqual(effect.read_bytes(), before)

    def test_effects_are_read_as_the_program_reads_them(self):
        run("export", twelve, "--format", "ahap", "--no-loss", "--out", self.folder)
        for actuator in ("", "quest"):
            given = tactspace.read_set(self.folder, actuator=actuator)
            words = ["--actuator", actuator] if actuator else []
            theirs = run_json("predict", self.folder, *words)
            square = tactspace.predict(given["waves"])
            np.testing.assert_array_equal(square[np.triu_indices(len(square), 1)], theirs["condensed"])
        several = tactspace.read_set(sorted(self.folder.glob("*.ahap"))[:3])
        self.assertEqual(len(several["names"]), 3)
        with self.assertRaises(ValueError):
            tactspace.read_set(self.folder, actuator="a motor that nobody knows")


class Exported(Folder):
    def test_files_and_what_they_cost_are_the_program_s(self):
        given = tactspace.read_set(four)
        for format, words, options in (("ahap", [], {}), ("haptic", ["--onto", "quest"], {"onto": "quest"}),
                                       # At the model's rate: the last bits of resampling are soxr's.
                                       ("wav", ["--rate", 10000, "--bits", "float"],
                                        {"rate_hz": 10000, "bits": "float"})):
            with self.subTest(format):
                ours, theirs = self.folder / format / "ours", self.folder / format / "theirs"
                answer = tactspace.export(given, ours, format, **options)
                told = run_json("export", four, "--format", format, *words, "--out", theirs)
                told["files"] = [{key: value.replace(str(theirs), str(ours)) if isinstance(value, str) else value
                                  for key, value in one.items()} for one in told["files"]]
                for key in ("synthetic_patterns", "synthetic_model", "actuators"):
                    told["loss"].pop(key, None)
                self.assertEqual(json.loads(json.dumps(answer)), told)
                for file in ours.iterdir():
                    self.assertEqual(file.read_bytes(), (theirs / file.name).read_bytes(), file.name)
                with self.assertRaises(FileExistsError) as caught:
                    tactspace.export(given, ours, format, loss=False, **options)
                self.assertEqual(pathlib.Path(caught.exception.filename).parent, ours)
                tactspace.export(given, ours, format, loss=False, overwrite=True, **options)

    def test_what_cannot_be_exported_is_refused(self):
        given = tactspace.read_set(four)
        for words, options in {"rate_hz: expected 10000, 44100 or 48000, got 8000": {"format": "wav", "rate_hz": 8000},
                               'rate_hz: expected format "wav" or "csv"': {"format": "ahap", "rate_hz": 44100},
                               'bits: expected one of "16", "24", "float", got "8"': {"format": "wav", "bits": "8"},
                               "nobody": {"format": "ahap", "patterns": ["nobody"]},
                               "midi": {"format": "midi"}}.items():
            with self.subTest(words), self.assertRaisesRegex(ValueError, words):
                tactspace.export(given, self.folder / "out", **options)
        self.assertFalse((self.folder / "out").exists())


class Asked(Folder):
    def test_what_separates_a_pair_is_the_program_s(self):
        given = tactspace.read_set(four)
        c, a, b = given["names"][:3]
        theirs = run_json("separate", four, "--pair", f"{a},{b}", "--closest", 1)
        self.assertTrue(theirs["changes"])
        for pair in ((a, b), [1, 2]):
            ours = tactspace.separate(given, pair, closest=1)
            self.assertEqual(ours, {key: theirs[key] for key in ours})
        theirs = run_json("separate", four, "--pair", f"{a},{b}", "--change", b, "--among", c)
        ours = tactspace.separate(given, (a, b), b, [c])
        self.assertEqual(ours, {key: theirs[key] for key in ours})
        for words, arguments in {"pair: expected two different patterns": [(0, 0)],
                                 "pair\\[1\\]: .*nobody": [(a, "nobody")],
                                 "change: expected the one of the pair": [(a, b), c],
                                 "pair\\[0\\]: expected 0 to": [(99, 0)]}.items():
            with self.subTest(words), self.assertRaisesRegex(ValueError, words):
                tactspace.separate(given, *arguments)
        with self.assertRaisesRegex(TypeError, "pair: expected two patterns, got 'ab'"):
            tactspace.separate(given, "ab")

    def test_what_a_report_tells_is_the_program_s(self):
        given = tactspace.read_set(twelve)
        a, b = given["names"][:2]
        page = self.folder / "page.html"
        for words, more in {(): {}, ("--count", 5, "--closer-than", f"{a},{b}"): {"count": 5, "closer_than": (a, 1)},
                            ("--closer-than", 12.5): {"closer_than": 12.5}}.items():
            theirs = run_json("report", twelve, "--out", page, *words)
            ours = tactspace.report(given, **more)
            self.assertEqual(ours, {key: theirs[key] for key in ours})
        faint = dict(given, patterns=[dict(one) for one in given["patterns"]])
        faint["patterns"][2]["amplitude_g"] = 0
        faint.pop("waves")
        name = given["names"][2]
        self.assertEqual(tactspace.report(faint)["left_out_unfelt"], [name])
        with_it = tactspace.report(faint, count=12, include_unfelt=True)
        self.assertIn(name, with_it["picked"])
        self.assertEqual(with_it["not_felt"], [name])
        for words, arguments in {"count: expected": {"count": 1}, "13 to pick of 12": {"count": 13},
                                 "closer_than: expected two different": {"closer_than": (0, 0)},
                                 "closer_than: expected": {"closer_than": -1}}.items():
            with self.subTest(words), self.assertRaisesRegex(ValueError, words):
                tactspace.report(given, **arguments)

    def test_steps_are_the_program_s(self):
        given = tactspace.read_set(twelve)
        a, b = given["names"][:2]
        out = self.folder / "steps.tactspace.json"
        theirs = run_json("steps", twelve, "--from", a, "--to", b, "--count", 4, "--out", out)
        ours = tactspace.steps(given, a, b, 4)
        made = ours.pop("set")
        self.assertEqual(ours, {key: theirs[key] for key in ours})
        written = tactspace.read_set(out)
        np.testing.assert_equal({key: made[key] for key in ("names", "patterns", "waves", "model")},
                                {key: written[key] for key in ("names", "patterns", "waves", "model")})
        tactspace.write_set(self.folder / "ours.tactspace.json", made)
        self.assertEqual((self.folder / "ours.tactspace.json").read_bytes(), out.read_bytes())
        for words, arguments in {"end: expected another pattern": [0, 0], "count: expected 2 to 16": [0, 1, 17],
                                 "parameter: expected a number that both": [0, 1, 3, "nothing"],
                                 "metric: expected one of": [0, 1, 3, "", "msm"]}.items():
            with self.subTest(words), self.assertRaisesRegex(ValueError, words):
                tactspace.steps(given, *arguments)

    def test_groups_are_the_program_s(self):
        given = dict(tactspace.read_set(twelve), dropped=[3])
        file = self.folder / "dropped.tactspace.json"
        tactspace.write_set(file, given)
        for named, options in {(): {}, ("--count", 3): {"count": 3}, ("--cut", 5): {"cut": 5.0}}.items():
            with self.subTest(options):
                theirs = run_json("groups", file, *named)
                ours = tactspace.groups(given, **options)
                self.assertEqual(ours, {key: theirs[key] for key in ours})
                self.assertEqual(ours["dropped"], [given["names"][3]])
        for words, options in {"count: expected at most 11": {"count": 12}, "count: expected 1 to": {"count": 0},
                               "cut: expected without count": {"count": 2, "cut": 1.0}}.items():
            with self.subTest(words), self.assertRaisesRegex(ValueError, words):
                tactspace.groups(given, **options)

    def test_measured_patterns_have_no_steps(self):
        given = dict(tactspace.read_set(four), patterns=None)
        given.pop("patterns")
        with self.assertRaisesRegex(ValueError, "start: expected a pattern made of parameters"):
            tactspace.steps(given, 0, 1)


if __name__ == "__main__":
    unittest.main()
