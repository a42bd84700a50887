#!/usr/bin/env python3
"""Makes one file of a page: one_file.py PAGE.html OUT.html

Beside PAGE.html lie the .js and .wasm of the same name. The program goes into the file compressed, as a page
from the disk can fetch nothing beside it; the browser inflates it (assets/web/shell.html).
"""

import base64
import pathlib
import sys
import zlib


def gzipped(content):
    squeeze = zlib.compressobj(9, zlib.DEFLATED, 16 + zlib.MAX_WBITS, 9)
    return squeeze.compress(content) + squeeze.flush()


def main():
    page, out = (pathlib.Path(argument) for argument in sys.argv[1:])
    html = page.read_text()
    call = f'<script async type="text/javascript" src="{page.stem}.js"></script>'
    if html.count(call) != 1:
        sys.exit(f"{page}: expected one {call}")
    code = page.with_suffix(".js").read_text().replace("</script", "<\\/script").replace("<!--", "<\\!--")
    program = base64.b64encode(gzipped(page.with_suffix(".wasm").read_bytes())).decode()
    out.parent.mkdir(parents=True, exist_ok=True)
    out.write_text(html.replace(call, f'<script type="text/plain" id="program">{program}</script>\n'
                                      f"<script>{code}</script>"))


if __name__ == "__main__":
    main()
