"""What the module says of itself is true: its docstrings, its signatures, its types."""

import ast
import inspect
import re
import tempfile
import unittest

import numpy as np
import tactspace
from places import root, run, twelve

STUB = ast.parse((root / "app/python/__init__.pyi").read_text())
FUNCTIONS = {name: value for name, value in vars(tactspace).items()
             if callable(value) and not name.startswith("_")}


def stub_functions():
    return {node.name: node for node in STUB.body if isinstance(node, ast.FunctionDef)}


class Help(unittest.TestCase):
    def test_the_stub_has_the_same_functions_parameters_and_defaults(self):
        self.assertEqual(set(stub_functions()), set(FUNCTIONS))
        for name, node in stub_functions().items():
            with self.subTest(name):
                signature = inspect.signature(FUNCTIONS[name])
                arguments = node.args.args + node.args.kwonlyargs
                self.assertEqual([one.arg for one in arguments], list(signature.parameters))
                named = [one.name for one in signature.parameters.values()
                         if one.kind is inspect.Parameter.KEYWORD_ONLY]
                self.assertEqual([one.arg for one in node.args.kwonlyargs], named)
                given = [one.default for one in signature.parameters.values()
                         if one.default is not inspect.Parameter.empty]
                self.assertEqual([ast.literal_eval(one) for one in node.args.defaults + node.args.kw_defaults], given)

    def test_the_defaults_that_are_written_are_those_that_hold(self):
        # A call with what the signature says is the call without it.
        given = tactspace.read_set(twelve)
        waves, square = given["waves"][:4], np.arange(36.0).reshape(6, 6)
        square = np.triu(square, 1) + np.triu(square, 1).T
        ratings = dict(names=list("abcdef"), participants=["p"], ratings=[np.arange(15.0) % 7])
        of_set = {"waves": waves, "ratings": tactspace.predict(waves), "model": {"nc_weight": 0.9}}
        calls = {"predict": [waves], "unfelt": [waves], "stages": [waves[0]], "space": [square], "subset": [square, 3],
                 "compare": [square, ratings], "train": [[of_set]], "render": [given["patterns"][0]],
                 "read_set": [twelve], "paper": [[of_set]], "steps": [given, 0, 1], "groups": [given],
                 "report": [given],
                 "separate": [dict(given, **{key: given[key][:3] for key in ("names", "patterns", "waves")}),
                              (0, 1)]}
        for name, arguments in calls.items():
            with self.subTest(name):
                parameters = inspect.signature(FUNCTIONS[name]).parameters
                named = {key: one.default for key, one in parameters.items()
                         if one.default is not inspect.Parameter.empty}
                plain = FUNCTIONS[name](*arguments)
                np.testing.assert_equal(FUNCTIONS[name](*arguments, **named), plain)

    def test_docstrings_tell_every_parameter_shapes_and_units(self):
        for name, function in FUNCTIONS.items():
            with self.subTest(name):
                text = inspect.getdoc(function)
                self.assertNotIn("--\n", text)
                for parameter in inspect.signature(function).parameters:
                    self.assertRegex(text, rf"(?m)^(\w+, )*{parameter}\b")
                self.assertRegex(text, r"Returns (a|an) (array|dict)|Returns \(|Returns None")
                self.assertRegex(text, r"\([A-Za-z0-9][^()\n]*,[^()\n]*\)|\bn\b")  # a shape
                self.assertRegex(text, r"\b(g|Hz|seconds|unit|units|um)\b")
        self.assertIn("ValueError", tactspace.__doc__)

    def test_docstrings_tell_every_key_that_comes_back(self):
        given = tactspace.read_set(twelve)
        square = tactspace.predict(given["waves"])
        rated = tactspace.compare({"pm": square, "mine": square[::-1, ::-1]}, square, given={"same": square})
        with tempfile.TemporaryDirectory() as folder:
            exported = tactspace.export(given, folder, "wav")
        answers = {"groups": tactspace.groups(given), "report": tactspace.report(given),
                   "steps": tactspace.steps(given, 0, 1, 3), "separate": tactspace.separate(given, (0, 1)),
                   "paper": tactspace.paper([dict(given, ratings=square)]), "export": exported,
                   "stages": tactspace.stages(given["waves"][0]), "subset": tactspace.subset(square, 3),
                   "compare": rated["mine"],
                   "train": tactspace.train([dict(given, ratings=square)], step=0.5), "read_set": given}
        answers["stages"] = dict(answers["stages"], **answers["stages"]["channels"]["FA1"],
                                 **answers["stages"]["components"])
        for name, answer in answers.items():
            for key in answer:
                self.assertRegex(FUNCTIONS[name].__doc__, rf"\b{re.escape(key)}\b", name)

    def test_version_and_metrics_are_the_program_s(self):
        self.assertIn(tactspace.__version__, run("--version"))
        for metric in tactspace.metrics:
            self.assertIn(f'"{metric}"', tactspace.predict.__doc__)


if __name__ == "__main__":
    unittest.main()
