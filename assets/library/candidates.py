"""Candidates of the library, six families, as a set file on standard output.

Each is a few numbers: curves from 0 to 1 of the amplitude, Hz of the first carrier, transients in g.
"""

import json

SET = {"tactspace": 1, "name": "Library, forty patterns (our own, not from a study)", "duration_s": 1.0, "patterns": []}


def add(family, name, words, **fields):
    pattern = {"name": name}
    hz = fields.pop("hz", 150.0)
    mix = fields.pop("mix", None)
    pattern["amplitude_g"] = fields.pop("g", 1.0)
    pattern["carriers"] = [{"frequency_hz": float(hz), "weight": 1.0}]
    if mix:
        pattern["carriers"].append({"frequency_hz": float(mix[0]), "weight": float(mix[1])})
    if "am" in fields:
        rate, depth = fields.pop("am")
        pattern["modulation"] = {"kind": "am", "frequency_hz": float(rate), "depth": float(depth)}
    if "beat" in fields:
        text, unit_s = fields.pop("beat")
        pattern["rhythm"] = {"text": text, "unit_s": unit_s}
        pattern["duration_s"] = round(len(text) * unit_s, 6)
    if "ramps" in fields:
        pattern["attack_s"], pattern["release_s"] = fields.pop("ramps")
    if "curve" in fields:
        pattern["amplitude_curve"] = [{"time_s": t, "value": v} for t, v in fields.pop("curve")]
    if "sweep" in fields:
        pattern["frequency_curve"] = [{"time_s": t, "frequency_hz": float(f)} for t, f in fields.pop("sweep")]
    if "ticks" in fields:
        pattern["transients"] = [
            {"time_s": t, "amplitude_g": a, "frequency_hz": float(f), "duration_s": d}
            for t, a, f, d in fields.pop("ticks")]
    if "s" in fields:
        pattern["duration_s"] = fields.pop("s")
    assert not fields, fields
    pattern["note"] = f"{family}: {words}. Made for tactspace; from no study."
    SET["patterns"].append(pattern)


def ticks(times, g=1.0, hz=200, s=0.012):
    return [(round(t, 6), g, hz, s) for t in times]


# Pulses: single and few, soft or hard at their edges.
for word, hz in (("low", 60), ("middle", 150), ("high", 280)):
    add("Pulse", f"Pulse {word}", f"one short pulse of {hz} Hz", hz=hz, s=0.08, ramps=(0.005, 0.02))
    add("Pulse", f"Press {word}", f"a pulse of {hz} Hz held for half a second", hz=hz, s=0.5, ramps=(0.01, 0.05))
    add("Pulse", f"Double {word}", f"two pulses of {hz} Hz", hz=hz, beat=("xx--xx--", 0.05), ramps=(0.005, 0.01))
    add("Pulse", f"Triple {word}", f"three pulses of {hz} Hz", hz=hz, beat=("x=-x=-x=-", 0.06), ramps=(0.005, 0.01))
add("Pulse", "Pulse faint", "one faint pulse", g=0.25, s=0.08, ramps=(0.005, 0.02))
add("Pulse", "Pulse strong", "one strong pulse", g=2.5, s=0.08, ramps=(0.002, 0.02))
add("Pulse", "Short long", "a dot and a dash", beat=("x--x====", 0.06))
add("Pulse", "Long short", "a dash and a dot", beat=("x====--x", 0.06))
add("Pulse", "Steady", "one second that stays as it is", g=0.8, ramps=(0.02, 0.05))
add("Pulse", "Steady deep", "one second of 45 Hz", hz=45, ramps=(0.02, 0.05))

# Ticks: transients alone.
add("Tick", "Tick", "one dry tick", g=0.0, s=0.05, ticks=ticks([0.0]))
add("Tick", "Tick hard", "one hard tick", g=0.0, s=0.05, ticks=ticks([0.0], g=3.0, hz=250, s=0.008))
add("Tick", "Tock", "one dull tick", g=0.0, s=0.08, ticks=ticks([0.0], hz=70, s=0.03))
add("Tick", "Tick tock", "a dry one, then a dull one", g=0.0, s=0.6,
    ticks=ticks([0.0]) + ticks([0.4], hz=70, s=0.03))
add("Tick", "Clock", "four ticks, even", g=0.0, s=1.0, ticks=ticks([0.0, 0.25, 0.5, 0.75]))
add("Tick", "Ratchet", "twelve ticks in a row", g=0.0, s=0.6, ticks=ticks([0.05 * k for k in range(12)], g=0.8))
add("Tick", "Ratchet slowing", "ticks that come ever later", g=0.0, s=1.0,
    ticks=ticks([0.0, 0.03, 0.07, 0.12, 0.19, 0.28, 0.4, 0.56, 0.78], g=0.9))
add("Tick", "Ratchet quickening", "ticks that come ever sooner", g=0.0, s=1.0,
    ticks=ticks([0.0, 0.22, 0.38, 0.5, 0.59, 0.66, 0.71, 0.75, 0.78], g=0.9))
add("Tick", "Bounce", "a ball that comes to rest", g=0.0, s=1.0,
    ticks=[(t, a, 90.0, 0.03) for t, a in ((0.0, 2.0), (0.32, 1.3), (0.54, 0.85), (0.69, 0.5), (0.79, 0.3))])
add("Tick", "Knock", "two knocks on wood", g=0.0, s=0.4, ticks=ticks([0.0, 0.2], g=2.0, hz=110, s=0.025))
add("Tick", "Knock three", "three knocks, the last one strong", g=0.0, s=0.7,
    ticks=ticks([0.0, 0.2], g=1.0, hz=110, s=0.025) + ticks([0.45], g=2.5, hz=110, s=0.03))

# Swells: curves of the amplitude.
for word, s in (("short", 0.4), ("long", 1.2)):
    add("Swell", f"Rise {word}", f"grows over {s} s", s=s, curve=((0.0, 0.0), (s * 0.95, 1.0), (s, 0.0)))
    add("Swell", f"Fall {word}", f"fades over {s} s", s=s, curve=((0.0, 0.0), (s * 0.05, 1.0), (s, 0.0)))
    add("Swell", f"Wave {word}", f"comes and goes in {s} s", s=s, curve=((0.0, 0.0), (s / 2, 1.0), (s, 0.0)))
add("Swell", "Wave deep", "comes and goes at 50 Hz", hz=50, s=1.2, g=1.2, curve=((0.0, 0.0), (0.6, 1.0), (1.2, 0.0)))
add("Swell", "Wave high", "comes and goes at 300 Hz", hz=300, s=1.2, curve=((0.0, 0.0), (0.6, 1.0), (1.2, 0.0)))
add("Swell", "Waves two", "comes and goes twice", s=1.2,
    curve=((0.0, 0.0), (0.3, 1.0), (0.6, 0.0), (0.9, 1.0), (1.2, 0.0)))
add("Swell", "Waves four", "comes and goes four times", s=1.2,
    curve=tuple((round(0.15 * k, 6), float(k % 2)) for k in range(9)))
add("Swell", "Breath", "in slowly, out slower", g=0.6, hz=80, s=1.5, curve=((0.0, 0.0), (0.6, 1.0), (0.75, 1.0), (1.5, 0.0)))
add("Swell", "Take-off", "grows and climbs from 50 to 250 Hz", s=1.2, curve=((0.0, 0.1), (1.1, 1.0), (1.2, 0.0)),
    sweep=((0.0, 50), (1.2, 250)))
add("Swell", "Landing", "fades and sinks from 250 to 50 Hz", s=1.2, curve=((0.0, 0.0), (0.1, 1.0), (1.2, 0.1)),
    sweep=((0.0, 250), (1.2, 50)))
add("Swell", "Slide up", "from 60 to 300 Hz in a moment", s=0.3, ramps=(0.01, 0.03), sweep=((0.0, 60), (0.3, 300)))
add("Swell", "Slide down", "from 300 to 60 Hz in a moment", s=0.3, ramps=(0.01, 0.03), sweep=((0.0, 300), (0.3, 60)))
add("Swell", "Step up", "150 Hz, then twice as strong", s=0.8, curve=((0.0, 0.35), (0.4, 0.35), (0.4, 1.0), (0.8, 1.0)))
add("Swell", "Step down", "150 Hz, then half as strong", s=0.8, curve=((0.0, 1.0), (0.4, 1.0), (0.4, 0.35), (0.8, 0.35)))
add("Swell", "Charge", "grows, then a hard tick", s=0.8, g=0.7, curve=((0.0, 0.0), (0.65, 1.0), (0.66, 0.0)),
    ticks=ticks([0.7], g=3.0, hz=120, s=0.02))
add("Swell", "Impact", "a hard tick that rings out", s=0.9, g=0.8, hz=90, curve=((0.0, 1.0), (0.9, 0.0)),
    ticks=ticks([0.0], g=2.5, hz=200, s=0.02))

# Heartbeats.
for word, text, unit_s, hz in (("calm", "x-x-------", 0.1, 55), ("bright", "x-x-------", 0.1, 160),
                               ("fast", "x-x------x-x------", 0.055, 55)):
    add("Heartbeat", f"Heartbeat {word}", f"two beats and a rest, {hz} Hz", hz=hz, g=1.3, beat=(text, unit_s), ramps=(0.01, 0.02))
add("Heartbeat", "Heartbeat soft", "two soft beats, the second fainter", hz=45, s=1.0,
    curve=((0.0, 0.0), (0.06, 1.0), (0.14, 0.0), (0.26, 0.0), (0.31, 0.6), (0.38, 0.0), (1.0, 0.0)))
add("Heartbeat", "Heartbeat racing", "beats that come ever sooner", hz=55, g=0.0, s=1.2,
    ticks=ticks([0.0, 0.12, 0.45, 0.56, 0.8, 0.89, 1.05, 1.13], g=1.5, hz=55, s=0.06))
add("Heartbeat", "Heartbeat missing", "a beat, and one that does not come", hz=55, g=0.0, s=1.2,
    ticks=ticks([0.0, 0.15, 0.6], g=1.5, hz=55, s=0.07))

# Alarms.
add("Alarm", "Alarm even", "on and off, eight times a second", g=1.5, hz=200, beat=("x-" * 8, 0.0625))
add("Alarm", "Alarm slow", "on and off, twice a second", g=1.5, hz=200, beat=("x==-x==-", 0.125))
add("Alarm", "Alarm urgent", "sixteen times a second", g=2.0, hz=250, beat=("x-" * 16, 0.03125))
add("Alarm", "Siren", "up and down between 80 and 300 Hz", g=1.5, s=1.2,
    sweep=((0.0, 80), (0.3, 300), (0.6, 80), (0.9, 300), (1.2, 80)))
add("Alarm", "Two-tone", "low and high in turn", g=1.5, s=1.2,
    sweep=((0.0, 80), (0.3, 80), (0.3, 280), (0.6, 280), (0.6, 80), (0.9, 80), (0.9, 280), (1.2, 280)))
add("Alarm", "SOS", "three short, three long, three short", hz=180, g=1.3,
    beat=("x-x-x--x==-x==-x==--x-x-x-", 0.05))
add("Alarm", "Insisting", "three pulses, each stronger", hz=180, s=1.0, g=2.0,
    curve=((0.0, 0.2), (0.2, 0.2), (0.2, 0.0), (0.35, 0.0), (0.35, 0.5), (0.55, 0.5), (0.55, 0.0), (0.7, 0.0), (0.7, 1.0), (1.0, 1.0)))
add("Alarm", "Ringing", "a telephone: two trains of pulses", hz=220, g=1.3, beat=("x-x-x-x-----x-x-x-x-----", 0.045))
add("Alarm", "Buzzer", "one rough second", hz=180, g=1.8, am=(28, 1.0), ramps=(0.005, 0.01))
add("Alarm", "Countdown", "three short, one long", hz=200, g=1.3, beat=("x---x---x---x====", 0.07))

# Textures: what goes on without a beat.
add("Texture", "Gravel", "rough and deep", hz=70, g=1.2, am=(17, 1.0), ramps=(0.05, 0.05))
add("Texture", "Sand", "fine and high", hz=300, g=0.6, am=(45, 0.9), ramps=(0.05, 0.05))
add("Texture", "Purr", "a cat: 28 swells a second at 55 Hz", hz=55, g=1.0, am=(28, 1.0), ramps=(0.1, 0.1))
add("Texture", "Tremble", "eight swells a second", hz=150, g=1.0, am=(8, 1.0), ramps=(0.05, 0.05))
add("Texture", "Flutter", "faint, thirteen swells a second", hz=220, g=0.35, am=(13, 1.0), ramps=(0.1, 0.1))
add("Texture", "Sway", "three swells a second", hz=120, g=1.0, am=(3, 1.0))
add("Texture", "Chord", "100 and 230 Hz together", hz=100, mix=(230, 1.0), g=0.8, ramps=(0.05, 0.1))
add("Texture", "Beating", "150 and 156 Hz together, which swell", hz=150, mix=(156, 1.0), g=0.7)
add("Texture", "Drone", "40 Hz under 200 Hz", hz=40, mix=(200, 0.4), g=1.0, ramps=(0.1, 0.1))
add("Texture", "Silk", "a faint second of 250 Hz", hz=250, g=0.2, ramps=(0.15, 0.15))
add("Texture", "Rain", "faint ticks without a beat", g=0.0, s=1.2,
    ticks=[(t, a, 260.0, 0.01) for t, a in ((0.0, 0.5), (0.07, 0.9), (0.11, 0.4), (0.23, 0.7), (0.26, 1.0), (0.41, 0.5),
           (0.47, 0.8), (0.62, 0.6), (0.65, 0.4), (0.71, 1.0), (0.86, 0.5), (0.97, 0.8), (1.03, 0.4), (1.12, 0.7))])
add("Texture", "Engine", "a motor that starts", hz=40, s=1.5, g=1.2, am=(20, 0.8), curve=((0.0, 0.2), (0.3, 0.8), (1.5, 1.0)),
    sweep=((0.0, 30), (0.8, 60), (1.5, 90)))
add("Texture", "Crackle", "hard ticks over a hum", hz=60, g=0.3, s=1.0,
    ticks=[(t, 1.8, 300.0, 0.008) for t in (0.05, 0.13, 0.17, 0.34, 0.38, 0.52, 0.71, 0.77, 0.81, 0.93)])

print(json.dumps(SET))
