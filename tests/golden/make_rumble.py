"""Writes rumble.json: the bytes that game controllers are sent, from an independent encoder.

Source   published descriptions of the packets, written for reading and without a look at the C++ code: HD rumble by
         arithmetic on the 32-bit word of one 7-bit sample (bits 2-8 FM high, 9-15 AM high, 16-22 FM
         low, 23-29 AM low, 30-31 = 1) instead of byte by byte, checksums by zlib.
What     "hd_rumble": frames and their four bytes; "amplitudes": indices by search in the table of
         all 101 instead of by its inverse; "sony": frames and whole reports, in hexadecimal.
         Stops when a printed example is not met.
Run      python3 tests/golden/make_rumble.py
Needs    Python 3.11.
"""

import json
import math
import pathlib
import struct
import zlib

FOLDER = pathlib.Path(__file__).parent
COMMAND = "python3 tests/golden/make_rumble.py"


def amplitude(i):
    if i == 0:
        return 0.0
    if i < 16:
        return 2 ** (i / 4) / 119.6
    if i < 32:
        return 2 ** (i / 16) / 17.0
    return 2 ** (i / 32) / 8.7


TABLE = [amplitude(i) for i in range(101)]


def index(share):
    """Nearest on the logarithmic scale, within the segment that the share lies in."""
    if share <= 0:
        return 0
    slope, scale = (4, 119.6) if share < 0.115 else (16, 17.0) if share < 0.2274 else (32, 8.7)
    guess = slope * math.log2(scale * share)
    return min(range(101), key=lambda i: abs(i - guess))


def code(f_hz, lowest, highest):
    e = round(32 * math.log2(f_hz / 10))
    return min(max(e, lowest), highest)


def hd_rumble(low_hz, low, high_hz, high):
    il, ih = index(low), index(high)
    fl = code(low_hz if il else 160, 0x41, 0xBF) - 0x40
    fh = code(high_hz if ih else 320, 0x61, 0xDF) - 0x60
    word = fh << 2 | ih << 9 | fl << 16 | il << 23 | 1 << 30
    return struct.pack("<I", word)


def motor(share):
    return 0 if share <= 0 else min(max(math.floor(share * 255 + 0.5), 1), 255)


def sign(report):
    return report + struct.pack("<I", zlib.crc32(b"\xa2" + report))


def dualshock4(low, high):
    usb = bytes([5, 1, 0, 0, motor(high), motor(low)]).ljust(32, b"\0")
    bt = sign(bytes([0x11, 0xC0, 0, 1, 0, 0, motor(high), motor(low)]).ljust(74, b"\0"))
    return usb, bt


def dualsense(low, high, new, counter):
    block = bytearray(47)
    block[0], block[2], block[3] = (2 if new else 3), motor(high), motor(low)
    block[38] = 4 if new else 0
    usb = b"\x02" + bytes(block)
    bt = sign((bytes([0x31, counter << 4, 0x10]) + bytes(block)).ljust(74, b"\0"))
    return usb, bt


def require(got, expected, what):
    if got != expected:
        raise SystemExit(f"{what}: got {got}, expected {expected}")


require(hd_rumble(160, 0, 320, 0).hex(), "00014040", "neutral")
require(hd_rumble(160, 0.5, 320, 0).hex(), "00014062", "160 Hz, 0.5")
require(hd_rumble(160, 0, 320, 0.5).hex(), "00894040", "320 Hz, 0.5")
require(hd_rumble(160, 0.981, 795, 0.501).hex(), "a889c071", "795 and 160 Hz")
require(dualshock4(128 / 255, 64 / 255)[1][-4:].hex(), "34d9310a", "DualShock 4 checksum")
require(dualsense(128 / 255, 64 / 255, False, 0)[1][-4:].hex(), "c8737924", "DualSense checksum")

FRAMES = [
    (160.0, 0.0, 320.0, 0.0), (160.0, 0.5, 320.0, 0.0), (160.0, 0.0, 320.0, 0.5),
    (160.0, 0.981, 795.0, 0.501), (40.0, 0.3, 81.0, 0.2), (41.5, 0.05, 90.0, 0.003),
    (626.29, 0.12, 1252.57, 0.2), (700.0, 1.0, 1500.0, 1.0), (5.0, 2.0, 20.0, 0.113),
    (80.0, 0.6, 250.0, 0.3), (123.4, 0.0083, 456.7, 0.0099), (173.2, 0.2273, 200.0, 0.2275)]
SHARES = [0.0, 1e-4, 0.008, 0.0084, 0.01, 0.02, 0.05, 0.11, 0.1149, 0.1151, 0.15, 0.2, 0.2273,
          0.2275, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9, 0.99, 1.0, 1.5]
PADS = [(0.0, 0.0), (128 / 255, 64 / 255), (1.0, 0.0), (0.0, 1.0), (0.001, 0.7), (3.0, 0.2)]


def main():
    sony = []
    for k, (low, high) in enumerate(PADS):
        usb, bt = dualshock4(low, high)
        old_usb, old_bt = dualsense(low, high, False, k)
        new_usb, new_bt = dualsense(low, high, True, k + 10)
        sony.append({
            "low": low, "high": high, "dualshock4_usb": usb.hex(), "dualshock4_bluetooth": bt.hex(),
            "counter": k, "dualsense_usb": old_usb.hex(), "dualsense_bluetooth": old_bt.hex(),
            "counter_from_2_24": k + 10, "dualsense_usb_from_2_24": new_usb.hex(),
            "dualsense_bluetooth_from_2_24": new_bt.hex()})
    golden = {
        "command": COMMAND,
        "hd_rumble": [{"frame": f, "bytes": hd_rumble(*f).hex()} for f in FRAMES],
        "amplitudes": [{"share": s, "index": index(s), "amplitude": TABLE[index(s)]}
                       for s in SHARES],
        "sony": sony}
    (FOLDER / "rumble.json").write_text(json.dumps(golden, indent=1) + "\n")


main()
