"""Writes effects.json, beside this script: how Meta's renderer plays .haptic clips, by its published rules.

Source   Meta's Haptics SDK, core/renderer_c (MIT), read as a description and written again, sample by sample: a sine whose
         phase is a running sum of its frequency; a burst whose two shapes are mixed by the emphasis' frequency and whose
         gain falls in a straight line; the sine is multiplied by the ducking while a burst lasts; a new burst cuts the
         last one; 0.1 s more where the last point has an emphasis; 0.5 until the first frequency point.
What     clips of our own, the configuration that plays them, and the root mean square of every 20 ms.
Run      /usr/bin/python3 tests/golden/make_effects.py
"""
import json
import pathlib
import sys

import numpy as np

RATE_HZ = 10_000
FRAME = RATE_HZ // 50

QUEST = dict(gain=1.0, ducking=0.5, low=55.0, high=200.0, burst_gain=1.0, fade=0.0,
             first=(55.0, 36.4, "sine"), last=(165.0, 12.1, "square"))
FADING = dict(gain=0.8, ducking=0.2, low=60.0, high=110.0, burst_gain=0.9, fade=60.0,
              first=(55.0, 60.0, "sine"), last=(250.0, 20.0, "square"))


def shape(kind, phase):
    if kind == "sine":
        return np.sin(2 * np.pi * phase)
    return np.where(phase % 1 < 0.5, 1.0, -1.0)


def rendered(clip, acf):
    amplitude = [(p["time"], p["amplitude"]) for p in clip["amplitude"]]
    bursts = [(p["time"], p["emphasis"]["amplitude"], p["emphasis"]["frequency"])
              for p in clip["amplitude"] if "emphasis" in p]
    if "emphasis" in clip["amplitude"][-1]:
        amplitude.append((amplitude[-1][0] + 0.1, amplitude[-1][1]))
    t = np.arange(round(amplitude[-1][0] * RATE_HZ)) / RATE_HZ
    level = np.interp(t, *zip(*amplitude)) * acf["gain"]
    level[t < amplitude[0][0]] = 0.0
    share = np.full(len(t), 0.5)
    if clip["frequency"]:
        points = [(p["time"], p["frequency"]) for p in clip["frequency"]]
        share = np.where(t < points[0][0], 0.5, np.interp(t, *zip(*points)))
    hz = acf["low"] + share * (acf["high"] - acf["low"])
    phase = np.concatenate([[0.0], np.cumsum(hz / RATE_HZ)[:-1]])
    burst = np.zeros(len(t))
    active = np.zeros(len(t), bool)
    for k, (start, gain, sharp) in enumerate(bursts):
        length = (acf["first"][1] + sharp * (acf["last"][1] - acf["first"][1])) / 1000
        end = start + length if k + 1 == len(bursts) else min(start + length, bursts[k + 1][0])
        on = (t >= start) & (t < end)
        since = t[on] - start
        f = acf["first"][0] + sharp * (acf["last"][0] - acf["first"][0])
        mixed = (1 - sharp) * shape(acf["first"][2], f * since) + sharp * shape(acf["last"][2], f * since)
        burst[on] = gain * acf["burst_gain"] * (1 - acf["fade"] / 100 * since / length) * mixed
        active |= on
    return level * np.where(active, acf["ducking"], 1.0) * np.sin(2 * np.pi * phase) + burst


def point(time, amplitude, *emphasis):
    return {"time": time, "amplitude": amplitude} | (
        {"emphasis": {"amplitude": emphasis[0], "frequency": emphasis[1]}} if emphasis else {})


def curve(*points):
    return [{"time": time, "frequency": frequency} for time, frequency in points]


CLIPS = {
    "swell with two taps": {
        "amplitude": [point(0.0, 0.0), point(0.3, 0.6, 1.0, 0.2), point(0.5, 0.3, 0.9, 0.9), point(1.0, 0.0)],
        "frequency": curve((0.0, 0.0), (1.0, 1.0))},
    "taps that cut each other": {
        "amplitude": [point(0.05 * k / 5, 0.2, 0.5 + 0.04 * k, k / 12) for k in range(12)] + [point(0.4, 0.1)],
        "frequency": []},
    "late start, tap at the end": {
        "amplitude": [point(0.1, 0.7), point(0.5, 0.2), point(0.5, 0.8), point(0.7, 0.4, 0.8, 0.0)],
        "frequency": curve((0.2, 0.9), (0.4, 0.1))},
    "no taps": {
        "amplitude": [point(0.0, 1.0), point(0.25, 0.05), point(0.5, 0.9), point(0.8, 0.0)],
        "frequency": curve((0.0, 0.3), (0.4, 0.3), (0.4, 0.8))},
}


def frames(wave):
    wave = wave[: len(wave) // FRAME * FRAME].reshape(-1, FRAME)
    return [round(float(v), 9) for v in np.sqrt((wave**2).mean(axis=1))]


def acf_text(acf):
    bursts = [{"output_frequency": f, "duration_ms": ms, "shape": kind} for f, ms, kind in (acf["first"], acf["last"])]
    return json.dumps({
        "metadata": {"device": "golden"},
        "continuous": {"gain": acf["gain"], "emphasis_ducking": acf["ducking"], "frequency_min": acf["low"],
                       "frequency_max": acf["high"]},
        "emphasis": {"gain": acf["burst_gain"], "fade_out_percent": acf["fade"], "frequency_min": bursts[0],
                     "frequency_max": bursts[1]}})


cases = [{"name": f"{name}, {device}", "acf": acf_text(acf), "rms_20_ms": frames(rendered(clip, acf)),
          "haptic": json.dumps({"version": {"major": 1, "minor": 0, "patch": 0},
                                "signals": {"continuous": {"envelopes": clip}}})}
         for name, clip in CLIPS.items() for device, acf in (("quest", QUEST), ("fading", FADING))]
made_by = f"make_effects.py, Python {sys.version.split()[0]}, NumPy {np.__version__}"
path = pathlib.Path(__file__).with_name("effects.json")
path.write_text(json.dumps({"made_by": made_by, "haptic": cases}, indent=1) + "\n")
