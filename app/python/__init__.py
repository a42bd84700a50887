# The package: the functions of the compiled module under their own names, so that pickle finds them,
# and a bar where progress=True asks for one. Their words and signatures are those of help.h.
import functools as _functools
import sys as _sys

from . import _tactspace

__doc__ = _tactspace.__doc__
__version__ = _tactspace.__version__
metrics = _tactspace.metrics


class _Bar:
    """How far the work is: in a notebook a bar below its cell, elsewhere a line of standard error."""

    def __init__(self):
        self.shown = None
        self.display = None
        ipython = _sys.modules.get("IPython")
        shell = ipython.get_ipython() if ipython else None
        self.is_notebook = shell is not None and hasattr(shell, "kernel")

    def __call__(self, share, text):
        said = (text, int(100.0 * share))
        if said == self.shown:
            return
        self.shown = said
        if self.is_notebook:
            self.draw(*said)
        else:
            done = said[1] // 4
            bar = "#" * done + " " * (25 - done)
            _sys.stderr.write(f"\r\x1b[K{text} [{bar}] {said[1]} %")
            _sys.stderr.flush()

    def draw(self, text, percent):
        from IPython.display import HTML, display

        bar = HTML(f'<progress max="100" value="{percent}"></progress> {text}, {percent} %')
        if self.display is None:
            self.display = display(bar, display_id=True)
        else:
            self.display.update(bar)

    def end(self):
        if self.shown is not None and not self.is_notebook:
            _sys.stderr.write("\r\x1b[K")
            _sys.stderr.flush()


def _named_here(function):
    @_functools.wraps(function)
    def call(*given, **named):
        if not isinstance(named.get("progress"), bool):
            return function(*given, **named)
        bar = _Bar()
        try:
            return function(*given, **dict(named, progress=bar if named["progress"] else None))
        finally:
            bar.end()

    call.__module__ = __name__
    call.__qualname__ = function.__name__
    return call


for _name, _value in list(vars(_tactspace).items()):
    if callable(_value) and not _name.startswith("_"):
        globals()[_name] = _named_here(_value)
