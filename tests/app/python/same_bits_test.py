"""The module and the command line give the same bits."""

import csv
import functools
import io
import json
import pathlib
import shutil
import tempfile
import unittest
import warnings

import numpy as np
import tactspace
from places import four, morse, root, run, run_json, sets, simulated_ratings, twelve


@functools.cache
def read(path):
    return tactspace.read_set(path)


@functools.cache
def pm(path):
    return tactspace.predict(read(path)["waves"], model=read(path)["model"])


def condensed(square):
    return square[np.triu_indices(len(square), 1)]


def with_nan(value):
    """A value of JSON, with NaN for null."""
    if isinstance(value, dict):
        return {key: with_nan(one) for key, one in value.items()}
    if isinstance(value, list):
        return [with_nan(one) for one in value]
    return float("nan") if value is None else value


def table(text):
    """Cells of a CSV, without its first line and the names in its first column."""
    return np.array([[float(cell) for cell in row[1:]] for row in list(csv.reader(io.StringIO(text)))[1:]])


class SameBits(unittest.TestCase):
    def setUp(self):
        # Warnings of synthetic ratings and of maps that say little are expected here.
        silence = warnings.catch_warnings()
        silence.__enter__()
        self.addCleanup(silence.__exit__, None, None, None)
        warnings.simplefilter("ignore")

    def same(self, ours, theirs):
        """Equal numbers, NaN included; no tolerance."""
        np.testing.assert_array_equal(np.asarray(ours, float), np.asarray(theirs, float))

    def test_pm_of_every_bundled_set(self):
        self.assertGreaterEqual(len(sets), 10)
        for path in sets:
            with self.subTest(path.name):
                self.same(condensed(pm(path)), run_json("predict", path)["condensed"])
                self.same(pm(path), pm(path).T)

    def test_the_plan_of_a_study(self):
        rival = tactspace.predict(read(twelve)["waves"], metric="msm", model=read(twelve)["model"])
        ours = tactspace.plan(pm(twelve), rival, [3, 5], studies=20, rho=0.7, reliability=0.5, pairs=40)
        theirs = run_json("plan", twelve, "--people", "3,5", "--studies", "20", "--rho", "0.7", "--reliability",
                          "0.5", "--pairs", "40")
        self.assertEqual(ours["assumed"], theirs["assumed"])
        for mine, other in zip(ours["studies"], theirs["studies"], strict=True):
            self.same([mine[key] for key in ("people", "rho", "rho_sd", "rho_rival", "reliability")],
                      [other[key] for key in ("people", "rho", "rho_sd", "rho_rival", "reliability")])
            for key in ("half_width", "power"):
                self.assertEqual(mine[key], other[key])
        for wrong in ({"people": []}, {"people": [0]}, {"people": [3], "pairs": 67}, {"people": [3], "rho": 2.0}):
            with self.subTest(wrong), self.assertRaisesRegex(ValueError, next(reversed(wrong))):
                tactspace.plan(pm(twelve), rival, **wrong)

    def test_maps_of_every_bundled_set(self):
        for path in sets:
            with self.subTest(path.name):
                points, stress = tactspace.space(pm(path))
                theirs = run_json("space", path)
                self.same(points, theirs["coordinates"])
                self.assertEqual(stress, theirs["stress1"])

    def test_subsets_of_every_bundled_set(self):
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder, "matrix.csv")
            for path in sets:
                run("predict", path, "--out", file)
                self.same(pm(path), table(file.read_text()))
                for objective in ("max-min", "max-sum"):
                    with self.subTest(path.name, objective=objective):
                        self.same_subset(path, file, objective)

    def same_subset(self, path, matrix, objective):
        given = read(path)
        names = given["names"]
        ours = tactspace.subset(
            pm(path), 4, given["locked"] + [2], given["dropped"] + [0], objective)
        theirs = run_json("subset", path, "-k", 4, "--keep", names[2], "--drop", names[0],
                          "--objective", objective, "--matrix", matrix)
        weakest = theirs["weakest"]
        self.assertEqual([names[k] for k in ours["members"]], theirs["patterns"])
        self.assertEqual([names[k] for k in ours["weakest"]], [weakest["a"], weakest["b"]])
        self.assertEqual(ours["weakest_dissimilarity"], weakest["dissimilarity"])
        self.assertEqual((ours["sum"], ours["bound"], ours["optimal"]),
                         (theirs["sum"], theirs["bound"], theirs["optimal"]))

    def test_every_metric(self):
        path = four
        waves = tactspace.read_set(path)["waves"]
        for metric in tactspace.metrics:
            with self.subTest(metric):
                self.same(condensed(tactspace.predict(waves, metric)),
                          run_json("predict", path, "--metric", metric)["condensed"])

    def test_waves_of_unlike_lengths_are_padded_as_in_a_set(self):
        with tempfile.TemporaryDirectory() as folder:
            waves = [wave[:length] for wave, length in
                     zip(tactspace.read_set(twelve)["waves"], (10000, 7000, 4321))]
            for k, wave in enumerate(waves):
                pathlib.Path(folder, f"{k}.txt").write_text("".join(f"{x!r}\n" for x in wave.tolist()))
            for metric in ("pm", "dtw", "rmse"):
                self.same(condensed(tactspace.predict(waves, metric)),
                          run_json("predict", folder, "--metric", metric)["condensed"])

    def test_edits_are_those_of_the_program(self):
        given = tactspace.read_set(twelve)
        first, second = given["names"][:2]
        edits = [("stretch", 1.2), "reverse", ("repeat", 2), ("join", given["patterns"][1]), ("fade-in", 0.05),
                 ("felt", 25), "trim", ("transpose", 0.8)]
        words = ["--stretch", 1.2, "--reverse", "--repeat", 2, "--join", second, "--fade-in", 0.05,
                 "--felt", 25, "--trim", "--transpose", 0.8]
        with tempfile.TemporaryDirectory() as folder:
            out = pathlib.Path(folder, "edited.tactspace.json")
            run("edit", twelve, "--pattern", first, *words, "--out", out)
            theirs = tactspace.read_set(out)
        ours = tactspace.edit(given["patterns"][0], edits)
        self.assertEqual(ours, theirs["patterns"][0])
        self.same(tactspace.render(ours), theirs["waves"][0])
        for wrong, why in ((["back"], "edits: expected one of stretch, "),
                           ([("stretch",)], "stretch: expected a number with it"),
                           ([("stretch", 0)], "stretch: expected a number from 0.01 to 100, got 0"),
                           ([("join", 2)], "join: expected a pattern with it"),
                           ([("reverse", 1)], "reverse: expected nothing with it")):
            with self.assertRaisesRegex(ValueError, why):
                tactspace.edit(given["patterns"][0], wrong)

    def test_the_model_of_a_set(self):
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder, "other.tactspace.json")
            model = '"model": {"nc_weight": 0.9, "coding": {"excitatory_layers": 1, "spike_cap": 7}}'
            path.write_text(twelve.read_text().rstrip().rstrip("}") + ", " + model + "}")
            given = tactspace.read_set(path)
            ours = tactspace.predict(given["waves"], model=given["model"])
            self.same(condensed(ours), run_json("predict", path)["condensed"])
            self.assertTrue(np.any(ours != tactspace.predict(given["waves"])))

    def test_any_number_of_threads(self):
        waves = tactspace.read_set(twelve)["waves"]
        self.same(tactspace.predict(waves, threads=1), tactspace.predict(waves, threads=3))

    def test_stages_are_those_of_the_program(self):
        given = tactspace.read_set(twelve)
        ours = tactspace.stages(given["waves"][3])
        with tempfile.TemporaryDirectory() as folder:
            run("stages", twelve, "--pattern", given["names"][3], "--out", folder)
            theirs = {file.stem: file.read_text() for file in pathlib.Path(folder).iterdir()}
        self.same(ours["wave"], table(theirs["input"])[:, 0])
        self.same(ours["brain"], table(theirs["brain_waveform"])[:, 0])
        self.same(ours["envelope"], table(theirs["envelope"])[:, 0])
        spikes = 0
        for row in csv.DictReader(io.StringIO(theirs["spikes"])):
            channel = ours["channels"][row["receptor"]]
            self.assertEqual(channel["spikes"][int(row["number"]), int(row["step"])], int(row["spikes"]))
            spikes += int(row["spikes"])
        self.assertEqual(spikes, sum(int(c["spikes"].sum()) for c in ours["channels"].values()))
        for row in csv.DictReader(io.StringIO(theirs["activation"])):
            channel = ours["channels"][row["receptor"]]
            for key in ("rate_imp_per_s", "radius_mm", "receptors", "silent"):
                self.assertEqual(float(channel[key]), float(row[key]))

    def test_patterns_of_a_set_render_to_its_waves(self):
        for path in [*sets, root / "assets/library/library.tactspace.json"]:
            given = tactspace.read_set(path)
            for pattern, wave in zip(given["patterns"], given["waves"]):
                self.same(tactspace.render(pattern), wave)

    def test_agreement_with_people(self):
        with tempfile.TemporaryDirectory() as folder:
            path = four
            file = simulated_ratings(path, folder)
            given = tactspace.read_set(path)
            ratings = tactspace.read_ratings(file, given["names"])
            self.assertEqual(len(ratings["synthetic"]), 4)
            metrics = ("pm", "spqi", "mtm", "level")
            rows = run_json("compare", path, "--ratings", file, *(f"--metric={m}" for m in metrics))
            matrices = {metric: tactspace.predict(given["waves"], metric) for metric in metrics}
            ours = tactspace.compare(matrices, ratings)
            for metric, row in zip(metrics, rows, strict=True):
                with self.subTest(metric):
                    self.all_of(row, ours[metric])
            self.assertIn("p_holm", ours["mtm"]["pm_less_this"]["both"])
            self.assertEqual(ours["pm"]["rho_low"], ours["pm"]["rho_resampled"]["patterns"]["low"])
            # A matrix alone is one of them, but for the difference from PM.
            for metric in metrics:
                alone = tactspace.compare(matrices[metric], ratings, metric)
                np.testing.assert_equal(alone, {k: v for k, v in ours[metric].items() if k != "pm_less_this"})
            # The mean alone does not tell how far people agree; rho is the same.
            alone = tactspace.compare(tactspace.predict(given["waves"]), ratings["mean"])
            self.assertEqual(alone["rho"], rows[0]["rho"])
            self.assertTrue(np.isnan(alone["reliability"]))

    def all_of(self, row, ours):
        """Every number of a row of compare --json is ours, but for what the files are called."""
        for key in set(row) - {"set", "metric", "left_out", "foreign", "synthetic_patterns", "synthetic_model"}:
            np.testing.assert_equal(ours[key], with_nan(row[key]), key)

    def test_what_is_left_where_a_matrix_is_given(self):
        with tempfile.TemporaryDirectory() as folder:
            file = simulated_ratings(four, folder)
            given = read(four)
            matrix = pathlib.Path(folder, "loudness.csv")
            run("predict", four, "--metric", "level", "--out", matrix)
            row = run_json("compare", four, "--ratings", file, "--metric", "pm", "--given", matrix)[0]
            level = tactspace.predict(given["waves"], "level")
            ours = tactspace.compare({"pm": pm(four)}, tactspace.read_ratings(file, given["names"]),
                                     given={"loudness": level})["pm"]
            self.assertEqual(ours["given"], row["given"])

    def test_the_paper_s_tables(self):
        with tempfile.TemporaryDirectory() as folder:
            file = simulated_ratings(four, folder)
            run("paper", four, "--ratings", file, "--out", pathlib.Path(folder, "paper"))
            given = read(four)
            ratings = tactspace.read_ratings(file, given["names"])
            ours = tactspace.paper([dict(given, ratings=ratings)])
            for name, rows in ours.items():
                with open(pathlib.Path(folder, "paper", name + ".csv"), newline="") as stream:
                    theirs = list(csv.DictReader(stream))
                self.assertEqual(len(rows), len(theirs))
                for mine, other in zip(rows, theirs):
                    texts = {key: value for key, value in mine.items() if isinstance(value, str)}
                    self.assertEqual(texts, {key: other[key] for key in texts})
                    for key in set(mine) - set(texts):
                        number = float("nan") if other[key] == "NA" else float(other[key])
                        np.testing.assert_equal(mine[key], number)

    def test_a_set_brings_its_own_ratings_along(self):
        ratings = read(morse)["ratings"]
        self.assertEqual(ratings["participants"], ["598 people, by ear"])
        self.assertIsNone(read(twelve)["ratings"])
        row = run_json("compare", morse, "--metric", "level")[0]
        ours = tactspace.compare(tactspace.predict(read(morse)["waves"], "level"), ratings)
        self.assertEqual((ours["rho"], ours["p"], ours["K"]), (row["rho"], row["p"], row["K"]))

    def same_training(self, ours, theirs):
        """Every number of train --json is ours, but for what tells of files."""
        for key in set(theirs) - {"sets", "best_of"}:
            np.testing.assert_equal(ours[key], with_nan(theirs[key]), key)
        for name, best in theirs["best_of"].items():
            finite = [-np.inf if value is None else value for value in best]
            np.testing.assert_array_equal(ours["best_of"][name], finite, name)
        for mine, other in zip(ours["sets"], theirs["sets"], strict=True):
            for key in set(other) & set(mine):
                np.testing.assert_equal(mine[key], with_nan(other[key]), key)

    def test_parameters_trained_on_what_sets_bring_along(self):
        """Two sets of unlike lengths with ratings of their own; a simulated person was included by name."""
        with tempfile.TemporaryDirectory() as folder:
            paths = []
            for path in (four, twelve):
                given = tactspace.read_set(path)
                file = simulated_ratings(path, folder)
                ratings = tactspace.read_ratings(file, given["names"])
                ratings["synthetic"] = ratings["synthetic"][1:]
                paths.append(pathlib.Path(folder, path.name))
                tactspace.write_set(paths[-1], dict(given, ratings=ratings))
                shutil.rmtree(pathlib.Path(folder, "answers"))
            ours = tactspace.train([tactspace.read_set(path) for path in paths], step=0.5, leave_out="sets")
            out = pathlib.Path(folder, "found.json")
            theirs = run_json("train", *paths, "--step", 0.5, "--leave-out", "sets", "--out", out)
            self.same_training(ours, theirs)
            self.assertEqual([one["participants"] for one in ours["sets"]], [4, 4])
            self.assertEqual(len(ours["without_set"]), 2)
            model = json.loads(out.read_text())["model"]
            self.assertEqual({key: ours["model"][key] for key in model}, model)
            row = run_json("compare", paths[0], "--metric", "pm")[0]
            given = tactspace.read_set(paths[0])
            self.all_of(row, tactspace.compare(pm(paths[0]), given["ratings"], "pm"))

    def test_trained_parameters(self):
        with tempfile.TemporaryDirectory() as folder:
            path = four
            file = simulated_ratings(path, folder)
            given = tactspace.read_set(path)
            given["ratings"] = tactspace.read_ratings(file, given["names"])
            options = {"objective": "mean-abs-rho", "step": 0.5, "leave_out": "participants"}
            ours = tactspace.train([given], **options)
            theirs = run_json("train", path, "--ratings", file, "--objective", "mean-abs-rho",
                              "--step", 0.5, "--leave-out", "participants")
            self.same_training(ours, theirs)
            self.assertEqual(len(ours["without_participant"]), 4)
            self.assertEqual(ours["without_pattern"], [])
            # What was trained is a model to predict with.
            matrix = tactspace.predict(given["waves"], model=ours["model"])
            self.assertEqual(tactspace.compare(matrix, given["ratings"])["rho"],
                             ours["sets"][0]["rho_after"])


if __name__ == "__main__":
    unittest.main()
