"""Writes measured.json, beside this script: three axes as one, and an actuator's resonance.

Source   DFT321 (Landin et al. 2010) with numpy.fft; s^2 / (s^2 + s w0 / Q + w0^2) by
         scipy.signal.bilinear at the pre-warped w0 = 2 fs tan(pi f0 / fs), run by lfilter.
What     dft321: noise of three seeds (the generator of tests/support/golden.h), without its mean; one signal.
         resonance: noise through the filter, at 10 kHz.
         lag: numpy.correlate's largest magnitude, of a noisy piece of noise within a longer one.
Run      python3 tests/golden/make_measured.py
"""
import json
import pathlib
import sys

import numpy as np
import scipy
from scipy import signal


def noise(seed, samples, amplitude):
    values = []
    for _ in range(samples):
        seed = (1664525 * seed + 1013904223) % 2**32
        values.append(amplitude * (seed / 2147483648.0 - 1.0))
    return np.array(values)


def dft321(seeds, samples):
    axes = [noise(seed, samples, 1.0 + k) for k, seed in enumerate(seeds)]
    spectra = np.fft.rfft([axis - axis.mean() for axis in axes], axis=1)
    magnitude = np.sqrt((np.abs(spectra) ** 2).sum(axis=0))
    phase = np.angle(spectra.sum(axis=0))
    expected = np.fft.irfft(magnitude * np.exp(1j * phase), n=samples)
    return {"seeds": seeds, "samples": samples, "expected": expected.tolist()}


def resonance(f0, q, gain, samples, seed):
    fs = 10000.0
    w0 = 2 * fs * np.tan(np.pi * f0 / fs)
    b, a = signal.bilinear([gain, 0.0, 0.0], [1.0, w0 / q, w0 * w0], fs)
    expected = signal.lfilter(b, a, noise(seed, samples, 1.0))
    return {"resonance_hz": f0, "q": q, "gain": gain, "samples": samples, "seed": seed,
            "expected": expected.tolist()}


def lag(seed, samples, begin, length, sign):
    recording = noise(seed, samples, 1.0)
    piece = sign * recording[begin:begin + length] + noise(seed + 1, length, 0.5)
    correlation = np.correlate(recording, piece, "full")
    found = int(np.argmax(np.abs(correlation))) - (length - 1)
    return {"seed": seed, "samples": samples, "begin": begin, "length": length, "sign": sign,
            "lag": found}


def main():
    tables = {
        "made_by": {"python": sys.version.split()[0], "numpy": np.__version__,
                    "scipy": scipy.__version__},
        "dft321": [dft321([1, 2, 3], 64), dft321([4, 5, 6], 37)],
        "resonance": [resonance(80.0, 2.0, 1.0, 60, 7), resonance(175.0, 12.0, 0.4, 60, 8)],
        "lag": [lag(11, 300, 57, 90, 1.0), lag(12, 257, 0, 40, -1.0), lag(13, 300, 250, 50, 1.0)],
    }
    target = pathlib.Path(__file__).with_name("measured.json")
    target.write_text(json.dumps(tables) + "\n")


main()
