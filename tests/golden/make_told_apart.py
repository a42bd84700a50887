"""Writes told_apart.json: thresholds of odd-one-out trials, their posterior, and shares with intervals.

Source   the prior and the share of right answers printed in model/told_apart/threshold_posterior.h; the
         interval of Wilson 1927 as the two shares that a test of normal scores just does not refuse.
What     told_apart.json: 12 courses of 0 to 40 answers. "threshold_pm" is of the grid of the program, with its
         density even from half a step below to half a step above each threshold; "fine_threshold_pm" of one with
         80 times as many thresholds, for what the grid costs.
Run      python3 tests/golden/make_told_apart.py
Needs    Python 3.11, NumPy 1.24, SciPy 1.10 (Debian 12: python3-numpy, python3-scipy).
"""

import json
import pathlib

import numpy as np
from scipy.optimize import brentq
from scipy.special import expit, logit
from scipy.stats import norm

GUESS, LAPSE, TOLD = 1 / 3, 0.02, 0.75
SLOPES = np.array([1.0, 2.0, 4.0, 8.0, 16.0])
PROBABILITIES = (0.025, 0.25, 0.5, 0.75, 0.975)


def share_right(pm, log_threshold, slope):
    at_threshold = logit((TOLD - GUESS) / (1 - GUESS - LAPSE))
    return GUESS + (1 - GUESS - LAPSE) * expit(slope * (np.log(pm) - log_threshold) + at_threshold)


class Posterior:
    def __init__(self, low, high, answers, thresholds):
        self.log_pm = np.linspace(np.log(low / 8), np.log(high * 8), thresholds)
        self.slope, self.threshold = np.meshgrid(SLOPES, self.log_pm)
        score = np.zeros_like(self.threshold)
        for pm, right in answers:
            p = share_right(pm, self.threshold, self.slope)
            score += np.log(p if right else 1 - p)
        self.weight = np.exp(score - score.max())
        self.weight /= self.weight.sum()

    def below(self, probability):
        step = self.log_pm[1] - self.log_pm[0]
        edges = np.append(self.log_pm - step / 2, self.log_pm[-1] + step / 2)
        sums = np.append(0, np.cumsum(self.weight.sum(axis=1)))
        at = np.interp(probability, sums, edges)
        return float(np.exp(np.clip(at, self.log_pm[0], self.log_pm[-1])))

    def predicted(self, pm):
        p = share_right(pm, self.threshold, self.slope).ravel()
        order = np.argsort(p)
        sums = np.cumsum(self.weight.ravel()[order])
        ends = [float(p[order][np.searchsorted(sums, q)]) for q in (0.025, 0.975)]
        return [float(np.sum(self.weight.ravel() * p))] + ends

    def information(self, pm):
        """The mutual information of answer and threshold, from their joint distribution."""
        p = share_right(pm, self.threshold, self.slope)
        joint = np.stack([(self.weight * p).sum(axis=1), (self.weight * (1 - p)).sum(axis=1)])
        own = joint.sum(axis=0, keepdims=True) * joint.sum(axis=1, keepdims=True)
        return float(np.sum(joint * np.log(joint / own)))


def wilson(right, trials):
    def score(p):
        return (right / trials - p) / np.sqrt(p * (1 - p) / trials)

    z, tiny = norm.ppf(0.975), 1e-15
    inner = min(max(right / trials, tiny), 1 - tiny)
    low = 0.0 if right == 0 else brentq(lambda p: score(p) - z, tiny, inner, xtol=1e-15)
    high = 1.0 if right == trials else brentq(lambda p: score(p) + z, inner, 1 - tiny, xtol=1e-15)
    return [float(low), float(high)]


def main():
    random = np.random.default_rng(1999)
    cases = []
    for k, trials in enumerate([0, 1, 10, 10, 20, 20, 20, 40, 40, 40, 40, 40]):
        pairs = [round(v, 3) for v in np.sort(random.uniform(0.5, 60.0, 8))]
        threshold, slope = random.uniform(5.0, 40.0), 2 ** random.uniform(0, 4)
        answers = []
        for _ in range(trials):
            pm = float(random.choice(pairs))
            p = share_right(pm, np.log(threshold), slope)
            if k in (3, 8):
                p = 1.0 if k == 3 else GUESS
            answers.append([pm, bool(random.uniform() < p)])
        own = Posterior(pairs[0], pairs[-1], answers, 61)
        fine = Posterior(pairs[0], pairs[-1], answers, 60 * 80 + 1)
        right = sum(one for _, one in answers)
        cases.append({
            "range_pm": [pairs[0], pairs[-1]],
            "answers": answers,
            "probability": PROBABILITIES,
            "threshold_pm": [own.below(q) for q in PROBABILITIES],
            "fine_threshold_pm": [fine.below(q) for q in PROBABILITIES],
            "pm": pairs,
            "predicted": [own.predicted(pm) for pm in pairs],
            "information": [own.information(pm) for pm in pairs],
            "wilson": wilson(right, trials) if trials else [0.0, 1.0],
        })
    target = pathlib.Path(__file__).parent / "told_apart.json"
    target.write_text(json.dumps({"cases": cases}, indent=1) + "\n")


if __name__ == "__main__":
    main()
