"""Writes assets/physiology/absolute_thresholds_aosp.csv: our thresholds, moved onto another curve.

Source   the lowest acceleration that is felt at 41 frequencies, dB re 1 g, as the Android Open Source
         Project has it for its basic envelopes (Apache-2.0); taken for peak values.
What     At each of its frequencies all four curves of assets/physiology/absolute_thresholds.csv are
         moved by as many dB as bring the lowest of them onto it; at 500 Hz, beyond it, as at 400 Hz.
         Prints the root mean square of these moves.
Run      python3 tests/golden/make_thresholds.py
Needs    Python 3.11.
"""

import csv
import io
import math
import pathlib

PHYSIOLOGY = pathlib.Path(__file__).parents[2] / "assets" / "physiology"
STANDARD_GRAVITY = 9.80665
RECEPTORS = (("NP I", "FA1"), ("P", "FA2"), ("NP III", "SA1"), ("NP II", "SA2"))

# frequency, Hz: threshold, dB re 1 g
FELT_DB = {
    0.4: -97.81, 2.0: -69.86, 3.0: -62.81, 4.0: -58.81, 5.0: -56.69, 6.0: -54.77, 7.2: -52.85,
    8.0: -51.77, 8.64: -50.84, 10.0: -48.9, 10.37: -48.52, 12.44: -46.5, 14.93: -44.43,
    15.0: -44.35, 17.92: -41.96, 20.0: -40.36, 21.5: -39.6, 25.0: -37.48, 25.8: -36.93,
    30.0: -34.31, 35.0: -33.13, 40.0: -32.81, 50.0: -31.94, 60.0: -31.77, 70.0: -31.59,
    72.0: -31.55, 80.0: -31.77, 86.4: -31.94, 90.0: -31.73, 100.0: -31.9, 103.68: -31.77,
    124.42: -31.7, 149.3: -31.38, 150.0: -31.35, 179.16: -31.02, 200.0: -30.86, 215.0: -30.35,
    250.0: -28.98, 258.0: -28.68, 300.0: -26.81, 400.0: -19.81,
}

HEADER = """\
# Absolute thresholds of the four psychophysical channels, after a second source.
#
# Source      lowest acceleration felt, by frequency: Android Open Source Project, Apache-2.0; itself
#             evidently read from a published curve of displacements. Taken for peak values.
# Confidence  it says what is felt, not by which receptor: all four curves of absolute_thresholds.csv
#             are moved by the dB that bring the lowest of them onto it, at 500 Hz as at 400 Hz [ours].
# Units       frequency_hz: Hz. lowest_db_re_1g: dB re 1 g, of the source. threshold_log10_um_peak: log10
#             of um peak displacement; the model reads it.
# Between     knots: linear over log10 of the frequency; constant beyond the outermost ones.
# Made by     tests/golden/make_thresholds.py
"""


def own_curves():
    lines = (PHYSIOLOGY / "absolute_thresholds.csv").read_text().splitlines()
    curves = {}
    for row in csv.DictReader(line for line in lines if not line.startswith("#")):
        curves.setdefault(row["receptor"], []).append(
            (float(row["frequency_hz"]), float(row["threshold_log10_um_peak"]))
        )
    return curves


def value_at(curve, frequency_hz):
    if frequency_hz <= curve[0][0]:
        return curve[0][1]
    for (f0, v0), (f1, v1) in zip(curve, curve[1:]):
        if frequency_hz <= f1:
            return v0 + (v1 - v0) * math.log10(frequency_hz / f0) / math.log10(f1 / f0)
    return curve[-1][1]


def peak_um_log10(db_re_1g, frequency_hz):
    metres = 10.0 ** (db_re_1g / 20.0) * STANDARD_GRAVITY / (2.0 * math.pi * frequency_hz) ** 2
    return math.log10(1e6 * metres)


def main():
    curves = own_curves()
    moves = {
        f: peak_um_log10(db, f) - min(value_at(c, f) for c in curves.values())
        for f, db in FELT_DB.items()
    }
    print("rms %.2f dB" % (20.0 * math.sqrt(sum(m * m for m in moves.values()) / len(moves))))
    text = io.StringIO()
    text.write(HEADER)
    text.write("channel,receptor,frequency_hz,lowest_db_re_1g,threshold_log10_um_peak\n")
    for channel, receptor in RECEPTORS:
        for f in [*FELT_DB, 500.0]:
            moved = value_at(curves[receptor], f) + moves.get(f, moves[400.0])
            text.write("%s,%s,%g,%s,%.4f\n" % (channel, receptor, f, FELT_DB.get(f, ""), moved))
    (PHYSIOLOGY / "absolute_thresholds_aosp.csv").write_text(text.getvalue())


if __name__ == "__main__":
    main()
