"""Calls a metric written in Python on every pair of a set; run by tactspace compare --metric-from.

Arguments: file, function, samples (binary doubles, one pattern after the other, all as long), file for
the answer (binary doubles, the first with all others, then the second with those behind it, ...), rate
in Hz, number of patterns.
"""

import array
import copy
import importlib.util
import pathlib
import sys


def waves_of(samples, count):
    """Arrays of NumPy where it is installed, else of Python itself."""
    data = array.array("d", pathlib.Path(samples).read_bytes())
    length = len(data) // count
    waves = [data[k * length : (k + 1) * length] for k in range(count)]
    try:
        import numpy
    except ImportError:
        return waves
    return [numpy.array(wave) for wave in waves]


def main():
    path, function, samples, answer, rate_hz, count = sys.argv[1:]
    sys.stdout = sys.stderr
    sys.path.insert(0, str(pathlib.Path(path).resolve().parent))
    spec = importlib.util.spec_from_file_location("metric", path)
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    metric = getattr(module, function, None)
    if not callable(metric):
        raise ValueError(f"expected a function of this name, got {type(metric).__name__}")
    waves = waves_of(samples, int(count))
    apart = array.array("d")
    for i in range(len(waves)):
        for j in range(i + 1, len(waves)):
            value = float(metric(copy.copy(waves[i]), copy.copy(waves[j]), float(rate_hz)))
            if not 0 <= value < float("inf"):
                raise ValueError(f"patterns {i + 1} and {j + 1}: expected a number of 0 or more, got {value}")
            apart.append(value)
    with open(answer, "wb") as file:
        apart.tofile(file)


try:
    main()
except BaseException as error:
    print(f"{type(error).__name__}: {error}".splitlines()[0], file=sys.__stderr__)
    sys.exit(1)
