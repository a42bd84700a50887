#!/usr/bin/env python3
"""Writes the fonts of the page, with the signs that it can need: subset_fonts.py FOLDER

DejaVu has the signs that Inter lacks (viz/drawing/fonts.cpp), in one weight.
ImGui takes neither kerning nor alternates, and FreeType hints TrueType by itself.
"""

import pathlib
import sys

from fontTools import subset
from fontTools.ttLib import TTFont

FONTS = pathlib.Path("/usr/share/fonts")
INTER = ("opentype/inter/Inter-Regular.otf", "opentype/inter/Inter-SemiBold.otf")
DEJAVU = "truetype/dejavu/DejaVuSans.ttf"
# The signs that the interface and the bundled sets have, and those of the languages that are likely in names.
SIGNS = ((0x20, 0x7E), (0xA0, 0x17F), (0x1C4, 0x24F), (0x2B0, 0x2FF), (0x300, 0x36F), (0x370, 0x3FF), (0x400, 0x45F),
         (0x1E00, 0x1EFF), (0x2000, 0x206F), (0x2070, 0x20BF), (0x2100, 0x22FF), (0x2300, 0x23FF), (0x25A0, 0x27BF),
         (0xFFFD, 0xFFFD))


def write(name, signs, folder):
    options = subset.Options()
    options.layout_features = []
    options.drop_tables += ["GSUB", "GPOS", "GDEF", "FFTM"]
    options.hinting = name.endswith(".otf")
    font = subset.load_font(FONTS / name, options)
    subsetter = subset.Subsetter(options)
    subsetter.populate(unicodes=signs)
    subsetter.subset(font)
    (folder / name).parent.mkdir(parents=True, exist_ok=True)
    subset.save_font(font, folder / name, options)


def main():
    folder = pathlib.Path(sys.argv[1])
    signs = {code for first, last in SIGNS for code in range(first, last + 1)}
    for face in INTER:
        write(face, signs, folder)
    write(DEJAVU, signs - set(TTFont(FONTS / INTER[0]).getBestCmap()), folder)


if __name__ == "__main__":
    main()
