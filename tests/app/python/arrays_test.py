"""What is taken for an array, and what is refused with which words."""

import decimal
import errno
import unittest
import warnings

import numpy as np
import tactspace
from places import twelve

GIVEN = tactspace.read_set(twelve)
WAVES = np.array(GIVEN["waves"])


class Arrays(unittest.TestCase):
    def test_any_layout_and_type_of_the_same_numbers_is_the_same(self):
        # Numbers that every type holds.
        waves = np.round(WAVES[:3] * 100.0)
        expected = tactspace.predict(waves)
        strided = np.repeat(np.repeat(waves, 2, axis=0), 2, axis=1)[::2, ::2]
        self.assertFalse(strided.flags["C_CONTIGUOUS"])
        read_only = waves.copy()
        read_only.flags.writeable = False
        for name, given in {
            "float32": waves.astype(np.float32), "int16": waves.astype(np.int16),
            "big-endian": waves.astype(">f8"), "Fortran": np.asfortranarray(waves),
            "strided": strided, "backwards": waves[:, ::-1][:, ::-1], "read only": read_only,
            "rows": list(waves), "tuple": tuple(waves), "lists": waves.tolist(),
        }.items():
            with self.subTest(name):
                np.testing.assert_array_equal(tactspace.predict(given), expected)

    def test_a_condensed_matrix_is_its_square(self):
        square = tactspace.predict(WAVES)
        pairs = square[np.triu_indices(12, 1)]
        for given in (pairs, pairs.tolist(), square.tolist(), np.asfortranarray(square)):
            points, stress = tactspace.space(given, 2)
            np.testing.assert_array_equal(points, tactspace.space(square, 2)[0])
            self.assertEqual(points.shape, (12, 2))
            self.assertEqual(tactspace.subset(given, 5)["members"].tolist(),
                             tactspace.subset(square, 5)["members"].tolist())

    def test_what_comes_back_is_ones_own(self):
        first = tactspace.predict(WAVES[:3])
        first[:] = -1.0
        self.assertTrue((tactspace.predict(WAVES[:3]) >= 0.0).all())
        self.assertEqual(first.dtype, np.float64)

    def test_other_rates_are_resampled(self):
        tone = {"carriers": [{"frequency_hz": 150}], "duration_s": 0.5}
        high = {"carriers": [{"frequency_hz": 230}], "duration_s": 0.5}
        slow = [tactspace.render(one, 5000) for one in (tone, high)]
        self.assertEqual([len(wave) for wave in slow], [2500, 2500])
        self.assertEqual(len(tactspace.stages(slow[0], 5000)["wave"]), 5000)
        np.testing.assert_allclose(tactspace.predict(slow, "rmse", 5000),
                                   tactspace.predict([tactspace.render(one) for one in (tone, high)], "rmse"),
                                   atol=1e-3)  # the ends of what was cut off
        self.assertEqual(tactspace.predict(slow, rate_hz=5000).shape, (2, 2))

    def test_numbers_of_numpy_in_a_pattern(self):
        pattern = {"amplitude_g": np.float32(0.5), "carriers": ({"frequency_hz": np.int64(100)},)}
        plain = {"amplitude_g": 0.5, "carriers": [{"frequency_hz": 100}]}
        np.testing.assert_array_equal(tactspace.render(pattern), tactspace.render(plain))

    def test_maps_that_say_nothing_warn(self):
        with self.assertWarnsRegex(UserWarning, "3 patterns always fit in 3 dimensions: stress says"):
            tactspace.space([1.0, 2.0, 3.0])
        with self.assertWarnsRegex(UserWarning, "all dissimilarities are equal") as caught:
            tactspace.space(np.ones(10))
        self.assertEqual(caught.filename, __file__)
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            tactspace.space(tactspace.predict(WAVES))


class Memory(unittest.TestCase):
    """Numbers that need no room until they are copied: 80 TB as float64."""

    def test_numbers_without_room_are_a_memory_error(self):
        wide = np.broadcast_to(np.float32(0), (10**6, 10**7))
        long = np.broadcast_to(np.float32(0), 10**13)
        for name, call in {
            "predict": lambda: tactspace.predict(wide), "unfelt": lambda: tactspace.unfelt(wide),
            "stages": lambda: tactspace.stages(long), "space": lambda: tactspace.space(wide),
            "subset": lambda: tactspace.subset(wide, 2), "compare": lambda: tactspace.compare(wide, wide),
        }.items():
            with self.subTest(name), self.assertRaises(MemoryError):
                call()


class Refusals(unittest.TestCase):
    def no_number(self, sentence, function, *arguments):
        with self.assertRaises(TypeError) as caught:
            function(*arguments)
        self.assertIn(sentence, str(caught.exception))

    def test_masked_samples_do_not_count_in_silence(self):
        masked = np.ma.masked_array(WAVES, mask=False)
        predict = tactspace.predict
        np.testing.assert_array_equal(predict(masked), predict(WAVES))
        masked.mask[1, 5] = True
        self.refused("waves: expected numbers without a mask, got 1 that are masked", predict, masked)
        self.refused("waves[1]: expected numbers without a mask", predict, list(masked))

    def test_a_file_that_is_not_there(self):
        for read, file in ((tactspace.read_set, "nowhere/set.tactspace.json"),
                           (tactspace.read_ratings, "nowhere/r.csv")):
            with self.subTest(file), self.assertRaises(FileNotFoundError) as caught:
                read(file)
            self.assertEqual((caught.exception.errno, caught.exception.filename), (errno.ENOENT, file))
            self.assertEqual(caught.exception.strerror, "there is no such file")
        with self.assertRaises(FileNotFoundError) as caught:
            tactspace.write_set("nowhere/set.tactspace.json", GIVEN)
        self.assertEqual(caught.exception.filename, "nowhere/set.tactspace.json")

    def refused(self, sentence, function, *arguments, **named):
        with self.assertRaises(ValueError) as caught:
            function(*arguments, **named)
        self.assertIn(sentence, str(caught.exception))

    def test_waves(self):
        predict = tactspace.predict
        nan = WAVES[:3].copy()
        nan[2, 17] = np.nan
        huge = [WAVES[0], WAVES[1] * 1e9]
        self.refused("waves: expected at least two to compare, got 1", predict, WAVES[:1])
        self.refused("waves: expected at least two to compare, got 0", predict, [])
        self.refused("waves[2][17]: expected a finite number of g, got nan", predict, nan)
        self.refused("waves[1][", predict, huge)
        self.refused("waves: expected an array (n, samples), got shape (10000,)", predict, WAVES[0])
        self.refused("waves[1]: expected samples, got none", predict, [WAVES[0], []])
        self.refused("waves[0]: expected samples along one axis, got shape ()", predict, [1.0, 2.0])
        self.refused("waves[0]: expected at most 60 s, got 60.0001 s", predict, np.zeros((2, 600001)))
        self.no_number("waves: expected real numbers, got dtype complex128 and shape (2, 10000)",
                       predict, WAVES[:2] * 1j)
        self.no_number("waves[1][2]: expected a real number, got None of type NoneType",
                       predict, [[1.0, 2.0], [1.0, 2.0, None]])
        self.no_number("waves[0]: expected real numbers", predict, "ab")
        self.no_number("waves[0]: expected real numbers", predict, [["1", "2"], ["3", "4"]])
        self.no_number("waves[0][0]: expected a real number, got Decimal('1')", predict,
                       [[decimal.Decimal(1)], [1.0]])
        self.no_number("waves[0]: expected real numbers", predict, [[[1.0], [1.0, 2.0]], [1.0]])
        self.no_number("waves: expected an array (n, samples) or a list of arrays, got {'a': 1} of type dict",
                       predict, {"a": 1})
        self.refused("rate_hz: expected 100 to 1e+07, got 50", predict, WAVES, rate_hz=50)
        self.refused("rate_hz: expected 100 to 1e+07, got nan", predict, WAVES, rate_hz=np.nan)
        self.refused("threads: expected 0 to 1024, got -1", predict, WAVES, threads=-1)
        self.refused("wave: expected samples along one axis, got shape (12, 10000)",
                     tactspace.stages, WAVES)

    def test_what_nobody_feels_is_left_out_by_its_places(self):
        waves = WAVES[:4].copy()
        waves[1] = 0.0
        unfelt = tactspace.unfelt(waves)
        np.testing.assert_array_equal(unfelt, [1])
        self.assertEqual(len(tactspace.unfelt(WAVES[:3])), 0)
        picked = tactspace.subset(tactspace.predict(waves), 3, drop=unfelt)
        np.testing.assert_array_equal(picked["members"], [0, 2, 3])
        self.refused("4 to pick of 3", tactspace.subset, tactspace.predict(waves), 4, drop=unfelt)

    def test_names(self):
        self.refused("st-sim", tactspace.predict, WAVES, "st_sim")
        self.refused('objective: expected one of "max-min", "max-sum", got "sum"',
                     tactspace.subset, np.ones(3), 2, objective="sum")
        self.refused('scale: expected one of "guess"', tactspace.read_ratings, "x.csv", scale="likert")

    def test_matrices(self):
        space = tactspace.space
        square = tactspace.predict(WAVES)
        uneven = square.copy()
        uneven[1, 0] += 1.0
        diagonal = square.copy()
        diagonal[2, 2] = 3.0
        self.refused("D: expected the distances of 2 to 10,000 objects", space, np.ones(4))
        self.refused("or as n (n - 1) / 2 pairs, got shape (2, 3)", space, np.ones((2, 3)))
        self.refused("D: expected the distances", space, [[0.0]])
        self.refused("D[1, 0]: expected the same as the other way round", space, uneven)
        self.refused("D[2, 2]: expected 0 on the diagonal, got 3", space, diagonal)
        self.refused("D[1]: expected a finite number, or NaN, got inf", space, [1.0, np.inf, 2.0])
        self.refused("D[0, 1]: expected a finite number, or NaN, got -inf", space, [[0, -np.inf], [-np.inf, 0]])
        self.refused("dimensions: expected 1 to 10, got 0", space, square, 0)
        # As the window and the terminal say it.
        self.refused("13 to pick of 12: expected at most as many", tactspace.subset, square, 13)
        self.refused("1 to pick: expected at least 2", tactspace.subset, square, 1)
        self.refused("3 to pick, but 12 must be kept", tactspace.subset, square, 3, range(12))
        self.refused("keep: expected places 0 to 11, got -1", tactspace.subset, square, 3, [-1])
        self.refused("drop: expected places 0 to 11, got 12", tactspace.subset, square, 3, drop=[12])
        self.refused("one pattern cannot be both kept and dropped",
                     tactspace.subset, square, 3, [1], [1])

    def test_ratings(self):
        square = tactspace.predict(WAVES)
        self.refused("ratings: expected those of the 12 patterns of D, got 3",
                     tactspace.compare, square, [1.0, 2.0, 3.0])
        self.refused('there is no "participants"', tactspace.compare, square, {"names": ["a"]})
        self.refused("ratings: expected a row a participant, a column a pair, (1, 3), got (1, 2)",
                     tactspace.compare, [1.0, 2.0, 3.0],
                     {"names": list("abc"), "participants": ["p"], "ratings": [[1.0, 2.0]]})
        self.refused("sets: expected at least one", tactspace.train, [])
        self.refused('sets[0]: expected a dict with "waves" and "ratings"', tactspace.train, [GIVEN])
        self.refused("sets[0]: expected ratings of its 12 waves, got those of 3 patterns",
                     tactspace.train, [dict(GIVEN, ratings=[1.0, 2.0, 3.0])])
        self.refused("step: expected 1 divided by a whole number up to 40",
                     tactspace.train, [dict(GIVEN, ratings=square)], step=0.3)
        self.refused("expected several sets with ratings to leave one out", tactspace.train,
                     [dict(GIVEN, ratings=square)], leave_out="sets")

    def test_documents(self):
        self.refused("pattern: /amplitude_g: expected", tactspace.render, {"amplitude_g": -1})
        self.refused('pattern: /: does not know "amplitud_g"; the nearest key is "amplitude_g"',
                     tactspace.render, {"amplitud_g": 1})
        self.refused('pattern: /carriers/0: does not know "frequncy_hz"', tactspace.render,
                     {"carriers": [{"frequncy_hz": 1}]})
        self.refused("pattern: /rhythm/text: expected a rhythm", tactspace.render,
                     {"rhythm": {"text": "??"}})
        # What a set file says of a pattern besides is passed over.
        read = {"amplitude_g": 0.5, "effect": {"format": "ahap", "actuator": "core-haptics"}}
        np.testing.assert_array_equal(tactspace.render(read), tactspace.render({"amplitude_g": 0.5}))
        self.refused("model: /nc_weight: expected", tactspace.predict, WAVES, model={"nc_weight": "x"})
        self.refused('model: /coding: does not know "layers"', tactspace.predict, WAVES,
                     model={"coding": {"layers": 3}})
        self.no_number("model: /coding/spike_cap: expected numbers, texts, lists and dicts, got <object",
                       lambda: tactspace.predict(WAVES, model={"coding": {"spike_cap": object()}}))
        self.no_number("pattern: /carriers/1: expected texts for keys, got 3", tactspace.render,
                       {"carriers": [{"frequency_hz": 100}, {3: 1}]})
        self.refused("pattern: /carriers/0/frequency_hz: expected a finite number, got nan", tactspace.render,
                     {"carriers": [{"frequency_hz": float("nan")}]})

    def test_the_wrong_type_is_a_type_error_that_names_the_argument(self):
        square = tactspace.predict(WAVES)
        for words, call in {
            "metric: expected a text, got 3 of type int": lambda: tactspace.predict(WAVES, 3),
            "threads: expected a whole number, got 1.5 of type float": lambda: tactspace.predict(WAVES, threads=1.5),
            "rate_hz: expected a number, got 'high' of type str": lambda: tactspace.predict(WAVES, rate_hz="high"),
            "dimensions: expected a whole number, got None of type NoneType": lambda: tactspace.space(square, None),
            "k: expected a whole number, got '4' of type str": lambda: tactspace.subset(square, "4"),
            "keep[1]: expected a whole number, got 2.5 of type float": lambda: tactspace.subset(square, 4, [0, 2.5]),
            "drop: expected a list of places, got 3 of type int": lambda: tactspace.subset(square, 4, drop=3),
            "pattern: expected a dict, got 3 of type int": lambda: tactspace.render(3),
            "model: expected a dict, got 'pm' of type str": lambda: tactspace.predict(WAVES, model="pm"),
            "path: expected a text or a path, got 3 of type int": lambda: tactspace.read_set(3),
            "sets: expected a list of dicts, got 3 of type int": lambda: tactspace.train(3),
            "sets[0]: expected a dict, got 3 of type int": lambda: tactspace.train([3]),
            "edits: expected a list of edits, got 'reverse'": lambda: tactspace.edit({}, "reverse"),
            'ratings["names"][1]: expected a text, got 2': lambda: tactspace.compare(
                [1.0, 2.0, 3.0], {"names": ["a", 2, "c"], "participants": ["p"], "ratings": [[1.0, 2.0, 3.0]]}),
            "people[0]: expected a whole number, got 2.5": lambda: tactspace.plan(square, square, [2.5]),
            "progress: expected a function of (share, text), True or None, got 3":
                lambda: tactspace.predict(WAVES, progress=3),
        }.items():
            with self.subTest(words):
                self.no_number(words, call)
        # NumPy's whole numbers and arrays of them are taken.
        picked = tactspace.subset(square, np.int64(4), keep=np.array([0, 2]))["members"]
        np.testing.assert_array_equal(picked, tactspace.subset(square, 4, keep=[0, 2])["members"])


if __name__ == "__main__":
    unittest.main()
