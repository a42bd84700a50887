"""Where the tests of the Python module find things, and the program to hold it against."""

import json
import os
import pathlib
import subprocess

root = pathlib.Path(__file__).resolve().parents[3]
sets = sorted((root / "assets/sets").glob("*.json"))
twelve = root / "assets/sets/pm_2023_twelve.tactspace.json"
four = root / "assets/sets/park_choi_2011_am_4hz.tactspace.json"
morse = root / "assets/sets/morse_rothkopf_1957.tactspace.json"
program = os.environ["TACTSPACE"]


def run(*arguments):
    """What the program prints."""
    done = subprocess.run([program, *map(str, arguments)], capture_output=True, text=True)
    if done.returncode != 0:
        raise AssertionError(f"{arguments}: {done.stderr}")
    return done.stdout


def run_json(*arguments):
    return json.loads(run(*arguments, "--json"))


def simulated_ratings(set_path, folder, people=4):
    """A file of what simulated people say of a set: the program's own, labelled synthetic."""
    answers = pathlib.Path(folder) / "answers"
    ratings = pathlib.Path(folder) / "ratings.csv"
    run("study", set_path, "--simulate", people, "--out", answers, "--seed", 1)
    run("study", set_path, "--collect", answers, "--out", ratings)
    return ratings
