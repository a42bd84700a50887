"""Runs a command of the program for browsers (app/web) in headless Chromium, as if it ran on this system.

    in_chromium.py BUILD tactspace|tactspace_threads ARGUMENT...

BUILD is build/web. The page gets the files that arguments name, and fonts; what it writes behind --out is written
here. Prints what the command prints, and ends as it does.
"""

import base64
import contextlib
import http.server
import json
import os
import pathlib
import sys
import tempfile

from browser import Browser
from web_page import Server, serve_by

FONTS = pathlib.Path("/usr/share/fonts")  # viz/drawing/fonts.cpp

PAGE = """<!DOCTYPE html><meta charset="utf-8"><title>%s</title><script>
var said = {out: [], error: [], code: null};
var Module = {
  arguments: %s,
  print: (line) => { said.out.push(line); },
  printErr: (line) => { said.error.push(line); },
  onAbort: (why) => { said.error.push(String(why)); said.code = 134; },
  onExit: (code) => { said.code = code; },
  preRun: [() => {
    for (const [path, content] of Object.entries(%s)) {
      FS.mkdirTree(path.slice(0, path.lastIndexOf('/')) || '/');
      FS.writeFile(path, Uint8Array.from(atob(content), (one) => one.charCodeAt(0)));
    }
    for (const folder of %s) FS.mkdirTree(folder);
    FS.chdir(%s);
  }],
};
// The files at a path, as [path, content]: one, or those of a folder.
function written(path) {
  const {exists, object} = FS.analyzePath(path);
  if (!exists) return [];
  if (FS.isDir(object.mode))
    return FS.readdir(path).filter((name) => !['.', '..'].includes(name)).flatMap((name) => written(path + '/' + name));
  let text = '';
  for (const one of FS.readFile(path)) text += String.fromCharCode(one);
  return [[path, btoa(text)]];
}
</script><script src="%s.js"></script>"""

# What was said, once the command has ended; after five minutes it will not.
ENDED = """new Promise((done) => {
  const began = Date.now();
  const look = setInterval(() => {
    if (said.code === null && Date.now() - began < 3e5) return;
    clearInterval(look);
    done(said);
  }, 20);
})"""


def outputs_of(arguments):
    return [after for before, after in zip(arguments, arguments[1:]) if before == "--out"]


def page_of(kind, arguments):
    fonts = [*FONTS.glob("opentype/inter/Inter-*.otf"), *FONTS.glob("truetype/dejavu/DejaVuSans*.ttf")]
    paths = [*map(pathlib.Path, arguments), *fonts]
    files = {str(one.absolute()): base64.b64encode(one.read_bytes()).decode() for one in paths if one.is_file()}
    folders = [os.getcwd(), *(str(pathlib.Path(out).absolute().parent) for out in outputs_of(arguments))]
    # "</" would end the script.
    given = [json.dumps(one).replace("</", "<\\/") for one in (arguments, files, folders, os.getcwd())]
    return PAGE % (kind, *given, kind)


def serve(build, page):
    class Handler(Server):
        headers_too = True  # threads need them

        def do_GET(self):
            if self.path != "/":
                return http.server.SimpleHTTPRequestHandler.do_GET(self)
            self.send_response(200)
            self.send_header("Content-Type", "text/html")
            self.end_headers()
            self.wfile.write(page.encode())

    return serve_by(Handler, build)


def main():
    build, kind, *arguments = sys.argv[1:]
    address = serve(build, page_of(kind, arguments))
    with contextlib.ExitStack() as at_end:
        browser = Browser(at_end.enter_context(tempfile.TemporaryDirectory(ignore_cleanup_errors=True)))
        at_end.callback(browser.process.wait)
        at_end.callback(browser.process.terminate)
        browser.open_tab()

        def value(expression):
            return browser.ask("Runtime.evaluate", expression=expression, returnByValue=True, awaitPromise=True)["result"].get("value")

        browser.ask("Page.enable")
        # Between threads, emscripten loses a message now and then (its issue 25211).
        for _ in range(2):
            browser.events.clear()
            browser.ask("Page.navigate", url=address)
            browser.wait_for("Page.loadEventFired")
            said = value(ENDED)
            if said["code"] is not None:
                break
            print(f"{kind} {' '.join(arguments)} has not ended in Chromium", file=sys.stderr)
        else:
            return 1
        for error in said["error"]:
            print(error, file=sys.stderr)
        for line in said["out"]:
            print(line)
        for out in outputs_of(arguments):
            for path, content in value(f"written({json.dumps(str(pathlib.Path(out).absolute()))})"):
                pathlib.Path(path).parent.mkdir(parents=True, exist_ok=True)
                pathlib.Path(path).write_bytes(base64.b64decode(content))
        return said["code"]


if __name__ == "__main__":
    sys.exit(main())
