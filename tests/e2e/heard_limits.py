"""Limits and endings, as a recorder on the output hears them: the model here is NumPy's, and knows
nothing of the program but what its manual says.

    python3 heard_limits.py PROGRAM SCRATCH     on a running PulseAudio with a sink "haptic"

Patterns of one kind play at once, each on a channel of its own. Where the program, the server or the
recorder was too slow, those that it struck play once more: there the program tells of gaps, or the
recording has a hole; so does a stop without its fade. Anything else that is not as it must be fails at
once, also where it would be right the next time: a limit that is exceeded now and then is exceeded.
"""
import json
import os
import signal
import subprocess
import sys
import time

import numpy as np

PROGRAM, SCRATCH = sys.argv[1], sys.argv[2]
RATE = 48000.0
CHANNELS = 8
MAP = ",".join(f"aux{k}" for k in range(CHANNELS))
LOW_HZ = 2.0                      # of the table: 1 g per full scale from there to 512 Hz
HIGH_HZ = 512.0                   # ... which is how steep what passed it may be
REACH_HZ = LOW_HZ * 2 ** (-1 / 3)  # a third of an octave below
RMS, TRAVEL_MM, CEILING, FADE_S = 0.1, 0.5, 0.8, 0.005
LENGTHS_S = [0.1, 0.3, 1.0, 3.0]
TRIES = 6


def tone(hz, peak_g, seconds, phase=0.0):
    t = np.arange(round(seconds * 10000)) / 10000
    return peak_g * np.sin(2 * np.pi * hz * t + phase)


def table(channel, **limits):
    path = f"{SCRATCH}/table{channel}.json"
    points = [{"frequency_hz": LOW_HZ * 2 ** (k / 3), "g_per_full_scale": 1.0} for k in range(25)]
    with open(path, "w") as file:
        json.dump({"tactspace_calibration": 1, "device": "audio/PulseAudio/haptic", "channel": channel,
                   "points": points, **limits}, file)
    return ["--calibration", path]


def started(channel, patterns, *options):
    folder = f"{SCRATCH}/set{channel}"
    os.makedirs(folder, exist_ok=True)
    for old in os.listdir(folder):
        os.remove(f"{folder}/{old}")
    for k, samples in enumerate(patterns):
        np.savetxt(f"{folder}/p{k}.txt", samples, fmt="%.9f")
    which = ["--all", "--gap", "0"] if len(patterns) > 1 else ["--pattern", "p0"]
    return subprocess.Popen([PROGRAM, "play", folder, "--device", "audio/PulseAudio/haptic", "--channel",
                             str(channel), "--level", "1", "--json", *which, *options],
                            stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)


class Recording:
    def __enter__(self):
        self.path = f"{SCRATCH}/limits.raw"
        self.file = open(self.path, "wb")
        self.parec = subprocess.Popen(
            ["parec", "-d", "haptic.monitor", "--format=float32le", "--rate=48000",
             f"--channels={CHANNELS}", f"--channel-map={MAP}", "--no-remix", "--no-remap", "--raw",
             "--latency-msec=20"], stdout=self.file)
        self.until(lambda: os.path.getsize(self.path) > 0)
        return self

    def __exit__(self, *_):
        self.parec.terminate()
        self.parec.wait()
        self.file.close()

    def heard(self):
        whole = os.path.getsize(self.path) // (4 * CHANNELS) * CHANNELS
        return np.fromfile(self.path, np.float32, whole).reshape(-1, CHANNELS).astype(float)

    @staticmethod
    def until(is_true):
        for _ in range(3000):
            if is_true():
                return
            time.sleep(0.02)
        raise SystemExit("what was waited for did not come")

    def until_loud(self, channel, seconds):
        """Until so much of it was heard."""
        self.until(lambda: np.count_nonzero(np.abs(self.heard()[:, channel - 1]) > 1e-4)
                   > 0.9 * seconds * RATE)

    def until_silent(self, channels):
        def is_silent():
            tail = self.heard()[-int(0.2 * RATE):, [c - 1 for c in channels]]
            return not np.any(tail)
        self.until(is_silent)


def sounding(samples):
    loud = np.flatnonzero(np.abs(samples) > 1e-5)
    if loud.size == 0:
        raise SystemExit("nothing was heard")
    return samples[loud[0]:loud[-1] + 1]


class Ending(AssertionError):
    """No limit: a stop that came while the server was late, whose last 20 ms hole() leaves out."""


def check(is_right, words):
    if not is_right:
        raise AssertionError(words)


def of_tone(hz):
    """What judges a recording knows how steep it may be."""
    def marked(judge):
        judge.hz = hz
        return judge
    return marked


def hole(samples, hz):
    """Where sound is missing between its ends, s from its beginning: silence of 1 ms and more, or a
    step that a tone of `hz` at this strength does not make. None: nowhere."""
    if hz is None:
        return None
    margin, least = int(0.02 * RATE), int(0.001 * RATE)
    inner = samples[margin:-margin]
    if len(inner) < 2 * least:
        return None
    silent = np.convolve(inner == 0.0, np.ones(least), "valid") == least
    steepest = 1.5 * np.max(np.abs(inner)) * 2 * np.pi * hz / RATE
    jumps = np.abs(np.diff(inner)) > steepest
    at = [np.flatnonzero(each)[0] for each in (silent, jumps) if np.any(each)]
    return (min(at) + margin) / RATE if at else None


def loudest_second(samples, rate):
    sums = np.concatenate([[0.0], np.cumsum(samples ** 2)])
    window = int(rate)
    if len(samples) <= window:
        return np.sqrt(sums[-1] / window)
    return np.sqrt(np.max(sums[window:] - sums[:-window]) / window)


def motion(drive, rate):
    """Displacement and velocity, mm and mm/s, of a mass on a spring that 1 g per full scale pushes."""
    a = 2 * np.pi * REACH_HZ / np.sqrt(2)
    t = np.arange(int(1.5 / REACH_HZ * rate)) / rate
    size = 1 << int(len(drive) + len(t)).bit_length()
    push = np.fft.rfft(9806.65 * drive / rate, size)

    def answer(kernel):
        return np.fft.irfft(push * np.fft.rfft(kernel, size), size)[:len(drive) + len(t)]
    fall = np.exp(-a * t)
    return answer(fall * np.sin(a * t) / a), answer(fall * (np.cos(a * t) - np.sin(a * t)))


def farthest_mm(drive, rate):
    return np.max(np.abs(motion(drive, rate)[0]))


def farthest_stopped_mm(drive, rate):
    """... wherever it is stopped: from every state on, without a drive."""
    a = 2 * np.pi * REACH_HZ / np.sqrt(2)
    x, v = (m[::20] for m in motion(drive, rate))
    most = 0.0
    for t in np.linspace(0, 1 / REACH_HZ, 100):
        fall = np.exp(-a * t)
        most = max(most, np.max(np.abs(fall * (x * (np.cos(a * t) + np.sin(a * t)) + v * np.sin(a * t) / a))))
    return most


def through_table(pattern):
    """One pass as the table lets it pass: 1 within it, 0 from a third of an octave outside it on."""
    f = np.fft.rfftfreq(2 * len(pattern), 1e-4)
    outside = np.maximum(np.log2(LOW_HZ / np.maximum(f, 1e-9)), np.log2(np.maximum(f, 1e-9) / 512))
    soft = np.clip((1 / 3 - outside) * 6, 0, 1)
    spectrum = np.fft.rfft(pattern, 2 * len(pattern))
    return np.fft.irfft(spectrum * (0.5 - 0.5 * np.cos(np.pi * soft)))[:len(pattern)]


def peak_by_travel(pattern):
    rounds = int(np.ceil(3.0 / (len(pattern) / 10000))) + 1
    drive = through_table(pattern)
    return np.max(np.abs(drive)) * min(1.0, TRAVEL_MM / farthest_stopped_mm(np.tile(drive, rounds), 10000.0))


def level_by_rms(pattern):
    rounds = int(np.ceil(2.0 / (len(pattern) / 10000))) + 1
    return min(1.0, RMS / loudest_second(np.tile(pattern, rounds), 10000.0))


def continued(samples, hz, end):
    """The sine that was heard 60 to 20 ms before `end`, continued."""
    at = np.arange(end - int(0.06 * RATE), end - int(0.02 * RATE))
    basis = np.stack([np.sin(2 * np.pi * hz * at / RATE), np.cos(2 * np.pi * hz * at / RATE)], 1)
    weights, *_ = np.linalg.lstsq(basis, samples[at], rcond=None)
    all_at = np.arange(end - int(0.02 * RATE), end + int(0.01 * RATE))
    return all_at, weights[0] * np.sin(2 * np.pi * hz * all_at / RATE) + \
        weights[1] * np.cos(2 * np.pi * hz * all_at / RATE)


def fades(samples, hz):
    """It ends as a line from 1 to 0 within 5 ms; silence behind it. What that leaves unexplained, as
    a share of the peak."""
    last = int(np.flatnonzero(np.abs(samples) > 1e-5)[-1])
    padded = np.concatenate([samples, np.zeros(2000)])
    at, whole = continued(padded, hz, last)
    peak = np.max(np.abs(whole))
    count = FADE_S * RATE
    return min(np.max(np.abs(padded[at] - whole * np.clip((end - at) / count, 0, 1)))
               for end in range(last - 3, last + 60)) / peak


def limited_by_rms(channel, seconds):
    pattern = tone(150, 0.9, seconds)

    @of_tone(HIGH_HZ)
    def judge(samples):
        peak = np.max(np.abs(samples))
        meant = level_by_rms(pattern) * 0.9
        rms = loudest_second(samples, RATE)
        print(f"loop of {seconds} s: rms {rms:.4f} of {RMS}, peak {peak:.4f}, model {meant:.4f}")
        check(rms <= RMS * 1.003, "more than the rms limit")
        check(rms >= RMS * 0.97, "much less than the rms limit")
        check(abs(peak / meant - 1) < 0.02, "a peak that the model has not")
    return lambda: started(channel, [pattern], "--loop", "--longest", "2.5", "--buffer", "1000",
                           *table(channel, rms_limit=RMS)), judge


def limited_by_travel(channel, seconds, hz):
    pattern = tone(hz, 0.4, seconds)

    @of_tone(HIGH_HZ)
    def judge(samples):
        peak = np.max(np.abs(samples[:-int(0.01 * RATE)]))
        meant = peak_by_travel(pattern)
        moved = farthest_mm(samples, RATE)
        print(f"loop of {seconds} s: moves {moved:.3f} of {TRAVEL_MM} mm, peak {peak:.4f}, "
              f"model {meant:.4f}")
        check(moved <= TRAVEL_MM * 1.03, "farther than it may")
        check(abs(peak / meant - 1) < 0.05, "a peak that the model has not")
    return lambda: started(channel, [pattern], "--loop", "--longest", "2.5", "--buffer", "1000",
                           *table(channel, excursion_limit_mm=TRAVEL_MM)), judge


def limited_by_time(channel, seconds, peak_g, longest_s, *options):
    @of_tone(150)
    def judge(samples):
        peak, heard_s, unlike = np.max(np.abs(samples)), len(samples) / RATE, fades(samples, 150)
        print(f"loop of {seconds} s: peak {peak:.4f}, {heard_s:.4f} s, unlike a fade by {unlike:.4f}")
        wanted = min(peak_g, CEILING)
        check(abs(peak / wanted - 1) < 0.01 and peak <= CEILING + 1e-6, "not its peak, or the ceiling")
        check(abs(heard_s - longest_s - FADE_S) < 0.003, "not as long as --longest says")
        check(unlike < 0.03, "--longest ends in no fade")
    return lambda: started(channel, [tone(150, peak_g, seconds)], "--loop", "--longest", str(longest_s),
                           "--buffer", "1000", *options), judge


def ended_by(channel, number, *options):
    @of_tone(150)
    def judge(samples):
        unlike = fades(samples, 150)
        print(f"{number.name} with {options}: unlike a fade by {unlike:.4f}")
        if unlike >= 0.03:
            raise Ending(f"{number.name} ends in no fade")
    return lambda: started(channel, [tone(150, 0.4, 1.0)], "--loop", *options), judge


def ended_by_itself(channel, *options):
    """At its peak, where nothing softens it."""
    @of_tone(HIGH_HZ)
    def judge(samples):
        step = np.max(np.abs(np.diff(samples[-int(0.02 * RATE):])))
        print(f"an end at the peak: steps of {step:.4f}")
        check(step < 1.6 * 0.4 * 2 * np.pi * 150 / RATE, "a pattern's end is a blow")
    return lambda: started(channel, [tone(150, 0.4, 0.5, np.pi / 2)], *options), judge


def in_turn(channel):
    swings = [tone(5, 0.4, 0.25, phase) for phase in (0.0, 1.6, 3.1, 4.7)]

    @of_tone(None)  # one pattern goes over into the next: the program alone knows of gaps
    def judge(samples):
        moved = farthest_mm(samples, RATE)
        print(f"four swings in turn: {moved:.3f} of {TRAVEL_MM} mm")
        check(moved <= 1.05 * TRAVEL_MM, "plays in turn move it farther than it may")
        check(moved >= 0.5 * TRAVEL_MM, "plays in turn are held back without need")
    return lambda: started(channel, swings, *table(channel, excursion_limit_mm=TRAVEL_MM), "--buffer",
                           "1000"), judge


def is_whole(channel, play, judge, heard, wanted_code):
    """False: sound was missing, and nothing is said of the limits. What is wrong ends the test."""
    _, err = play.communicate()
    if "had gaps" in err:
        print(f"channel {channel} once more: gaps, as it says")
        return False
    samples = sounding(heard[:, channel - 1])
    missing_s = hole(samples, judge.hz)
    if missing_s is not None:
        print(f"channel {channel} once more: a hole in what was recorded, at {missing_s:.4f} s")
        return False
    try:
        check(play.returncode == wanted_code, f"exit code {play.returncode}: {err}")
        judge(samples)
    except Ending as why:
        print(f"channel {channel} once more: {why}")
        return False
    except AssertionError as why:
        raise SystemExit(f"channel {channel}: {why}") from None
    return True


def play_all(cases, interrupted=()):
    left = dict(cases)
    for _ in range(TRIES):
        with Recording() as recording:
            plays = {channel: start() for channel, (start, _) in left.items()}
            for channel in [c for c in interrupted if c in plays]:
                recording.until_loud(channel, 0.5)
                plays[channel].send_signal(interrupted[channel])
            for play in plays.values():
                recording.until(lambda: play.poll() is not None)
            recording.until_silent(plays)
            heard = recording.heard()
        for channel, play in plays.items():
            wanted = 128 + interrupted[channel] if channel in interrupted else 0
            if is_whole(channel, play, left[channel][1], heard, wanted):
                del left[channel]
        if not left:
            return
    raise SystemExit(f"never without gaps: channels {sorted(left)}")


SIGNALS = {1: signal.SIGINT, 2: signal.SIGTERM, 3: signal.SIGHUP, 4: signal.SIGINT}

play_all({**{1 + k: limited_by_rms(1 + k, seconds) for k, seconds in enumerate(LENGTHS_S)},
          **{5 + k: limited_by_travel(5 + k, seconds, hz)
             for k, (seconds, hz) in enumerate(zip(LENGTHS_S, [10, 10, 6, 3]))}})
play_all({**{1 + k: limited_by_time(1 + k, seconds, 2.0, 1.5, "--no-protection")
             for k, seconds in enumerate(LENGTHS_S)},
          **{5 + k: limited_by_time(5 + k, seconds, 0.3, 1.0) for k, seconds in enumerate(LENGTHS_S)}})
# The buffer that is taken unless another one is asked for, and a long one.
play_all({1: ended_by(1, signal.SIGINT), 2: ended_by(2, signal.SIGTERM, "--buffer", "400"),
          3: ended_by(3, signal.SIGHUP), 4: ended_by(4, signal.SIGINT, *table(4, rms_limit=0.5)),
          5: ended_by_itself(5, "--buffer", "400"), 6: ended_by_itself(6, *table(6), "--buffer", "400"),
          7: in_turn(7)}, SIGNALS)
