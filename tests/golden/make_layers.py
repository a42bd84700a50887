"""Writes layers.json: patterns of several layers, as samples.

Source   the equations at the heads of model/set/layers.h and model/pattern/pattern.h, written for reading in
         NumPy, without a look at the C++ code. Transients lie over silence, where their phase is 0.
What     layers (amplitude, carriers, modulation, duration, transients; gain, offset, mute, solo), and of
         their sum at 10 kHz every 61st sample, the sum of squares and the number of samples.
Run      python3 tests/golden/make_layers.py
Needs    Python 3.11, NumPy 1.24.
"""

import json
import pathlib
import platform

import numpy as np

RATE_HZ = 10_000


def bed(amplitude_g, hz, modulation_hz, duration_s, **beside):
    return {"amplitude_g": amplitude_g, "carriers_hz": hz, "modulation_hz": modulation_hz, "duration_s": duration_s,
            "transients": [], "gain": 1.0, "offset_s": 0.0, "mute": False, "solo": False} | beside


TICKS = [[0.02, 1.5, 180.0, 0.02], [0.9, 0.7, 60.0, 0.05]]
CASES = {
    "bed and late bed": [bed(0.8, [70.0], 4.0, 0.5), bed(0.5, [150.0, 220.0], 0.0, 0.4, gain=0.3, offset_s=0.25)],
    "ticks before and behind a bed": [bed(0.4, [90.0], 0.0, 0.3, offset_s=0.2),
                                      bed(0.0, [150.0], 0.0, 1.0, transients=TICKS, gain=2.0)],
    "one of three is mute": [bed(1.0, [50.0], 0.0, 0.2), bed(1.0, [100.0], 0.0, 0.6, mute=True, offset_s=0.1),
                             bed(0.5, [200.0], 10.0, 0.3)],
    "one of three is solo": [bed(1.0, [50.0], 0.0, 0.2), bed(1.0, [100.0], 0.0, 0.6, solo=True, mute=True),
                             bed(0.5, [200.0], 10.0, 0.9)],
}


def transient(t_s, time_s, amplitude_g, hz, duration_s):
    """A sine under Hann flanks of a quarter of its duration each."""
    since_s = t_s - time_s
    inside = (since_s >= 0) & (since_s < duration_s)
    edge = np.minimum(since_s, duration_s - since_s) / (0.25 * duration_s)
    window = np.where(edge < 1, 0.5 - 0.5 * np.cos(np.pi * edge), 1.0)
    return np.where(inside, amplitude_g * window * np.sin(2 * np.pi * hz * since_s), 0.0)


def total(layers):
    end_s = max(layer["offset_s"] + layer["duration_s"] for layer in layers)
    x = np.zeros(round(end_s * RATE_HZ))
    whole_s = np.arange(len(x)) / RATE_HZ
    solo = any(layer["solo"] for layer in layers)
    for layer in layers:
        if not (layer["solo"] if solo else not layer["mute"]):
            continue
        n = np.arange(round(layer["duration_s"] * RATE_HZ))
        t_s = n / RATE_HZ
        tone = sum(np.sin(2 * np.pi * hz * t_s) for hz in layer["carriers_hz"])
        if layer["modulation_hz"] != 0:
            tone = tone * np.sin(2 * np.pi * layer["modulation_hz"] * t_s)
        first = round(layer["offset_s"] * RATE_HZ)
        x[first:first + len(n)] += layer["gain"] * layer["amplitude_g"] * tone
        for time_s, amplitude_g, hz, duration_s in layer["transients"]:
            x += transient(whole_s, layer["offset_s"] + time_s, layer["gain"] * amplitude_g, hz, duration_s)
    return x


rows = []
for name, layers in CASES.items():
    wave = total(layers)
    rows.append({"name": name, "layers": layers, "samples": len(wave), "squares": float(np.sum(wave**2)),
                 "every_61st": wave[::61].tolist()})
path = pathlib.Path(__file__).with_name("layers.json")
made_by = {"python": platform.python_version(), "numpy": np.__version__}
path.write_text(json.dumps({"made_by": made_by, "layers": rows}, indent=1) + "\n")
