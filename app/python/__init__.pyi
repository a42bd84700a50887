"""Types of the module tactspace; help(tactspace) has shapes, units and errors."""

from os import PathLike
from typing import Any, Callable, Mapping, Sequence, TypedDict

import numpy as np
from numpy.typing import ArrayLike, NDArray

Numbers = NDArray[np.float64]
Counts = NDArray[np.int32]
Whole = int | np.integer[Any]
Places = Sequence[int] | NDArray[np.integer[Any]] | range
Progress = Callable[[float, str], object] | bool | None

__version__: str
metrics: tuple[str, ...]

class Ratings(TypedDict, total=False):
    names: list[str]
    named: bool
    participants: list[str]
    ratings: Numbers
    mean: Numbers
    synthetic: list[str]
    participants_left_out: int
    rehearsals_left_out: int
    left_out: list[dict[str, str]]
    remarks: list[str]

class Set(TypedDict):
    name: str
    names: list[str]
    waves: list[Numbers]
    rate_hz: float
    patterns: list[dict[str, Any] | None]
    model: dict[str, Any]
    ratings: Ratings | None
    measures: list[str]
    synthetic: list[bool]
    locked: list[int]
    dropped: list[int]
    remarks: list[str]
    document: dict[str, Any]

class Paper(TypedDict):
    table2: list[dict[str, Any]]
    pairs: list[dict[str, Any]]
    maps: list[dict[str, Any]]

class Channel(TypedDict):
    rate_imp_per_s: float
    slope_sum_imp_per_s: float
    radius_mm: float
    receptors: int
    silent: bool
    filtered_g: Numbers
    perceived: Numbers
    x_mm: Numbers
    y_mm: Numbers
    receptor_rate_imp_per_s: Numbers
    spikes: Counts
    central: Counts

class Stages(TypedDict):
    wave: Numbers
    components: dict[str, Numbers]
    channels: dict[str, Channel]
    brain: Numbers
    envelope: Numbers

class Subset(TypedDict):
    members: Counts
    weakest: tuple[int, int]
    weakest_dissimilarity: float
    sum: float
    optimal: bool
    bound: float

def predict(
    waves: ArrayLike | Sequence[ArrayLike],
    metric: str = "pm",
    rate_hz: float = 10000.0,
    threads: int = 0,
    model: Mapping[str, Any] | None = None,
    *,
    progress: Progress = None,
) -> Numbers: ...
def unfelt(
    waves: ArrayLike | Sequence[ArrayLike],
    rate_hz: float = 10000.0,
    threads: int = 0,
    model: Mapping[str, Any] | None = None,
) -> Numbers: ...
def stages(
    wave: ArrayLike, rate_hz: float = 10000.0, model: Mapping[str, Any] | None = None
) -> Stages: ...
def space(
    D: ArrayLike, dimensions: int = 3, threads: int = 0, *, progress: Progress = None
) -> tuple[Numbers, float]: ...
def subset(
    D: ArrayLike,
    k: Whole,
    keep: Places = (),
    drop: Places = (),
    objective: str = "max-min",
    threads: int = 0,
    time_limit_s: float = 60.0,
    *,
    progress: Progress = None,
) -> Subset: ...
def compare(
    D: ArrayLike | Mapping[str, ArrayLike],
    ratings: Ratings | ArrayLike,
    metric: str = "",
    threads: int = 0,
    *,
    given: Mapping[str, ArrayLike] | None = None,
    progress: Progress = None,
) -> dict[str, Any]: ...
def paper(
    sets: Sequence[Mapping[str, Any]], threads: int = 0, *, progress: Progress = None
) -> Paper: ...
def plan(
    D: ArrayLike,
    rival: ArrayLike,
    people: Places,
    rho: float | None = None,
    reliability: float | None = None,
    pilot: Ratings | ArrayLike | None = None,
    pairs: int = 0,
    studies: int = 200,
    seed: int = 12,
    threads: int = 0,
    *,
    progress: Progress = None,
) -> dict[str, Any]: ...
def train(
    sets: Sequence[Mapping[str, Any]],
    objective: str = "mean-rho",
    step: float = 0.1,
    leave_out: str = "",
    rate_hz: float = 10000.0,
    threads: int = 0,
    model: Mapping[str, Any] | None = None,
    *,
    progress: Progress = None,
) -> dict[str, Any]: ...
def render(pattern: Mapping[str, Any], rate_hz: float = 10000.0) -> Numbers: ...
def edit(
    pattern: Mapping[str, Any],
    edits: Sequence[str | tuple[str] | tuple[str, float] | tuple[str, Mapping[str, Any]]],
    model: Mapping[str, Any] | None = None,
) -> dict[str, Any]: ...
def separate(
    set: Mapping[str, Any],
    pair: tuple[str | int, str | int] | list[str] | list[int],
    change: str | int | None = None,
    among: Sequence[str | int] = (),
    closest: float = 5.0,
    threshold: float | None = None,
    threads: int = 0,
    *,
    progress: Progress = None,
) -> dict[str, Any]: ...
def report(
    set: Mapping[str, Any],
    count: Whole | None = None,
    closer_than: float | tuple[str | int, str | int] | list[str] | list[int] | None = None,
    include_unfelt: bool = False,
    threads: int = 0,
    time_limit_s: float = 60.0,
    *,
    progress: Progress = None,
) -> dict[str, Any]: ...
def steps(
    set: Mapping[str, Any],
    start: str | int,
    end: str | int,
    count: int = 5,
    parameter: str = "",
    metric: str = "pm",
    threads: int = 0,
    *,
    progress: Progress = None,
) -> dict[str, Any]: ...
def groups(
    set: Mapping[str, Any],
    count: int | None = None,
    cut: float | None = None,
    threads: int = 0,
    *,
    progress: Progress = None,
) -> dict[str, Any]: ...
def export(
    set: Mapping[str, Any],
    folder: str | PathLike[str],
    format: str,
    patterns: Sequence[str] = (),
    onto: str = "",
    rate_hz: float | None = None,
    bits: str | None = None,
    count: int = 0,
    loss: bool = True,
    overwrite: bool = False,
    threads: int = 0,
    *,
    progress: Progress = None,
) -> dict[str, Any]: ...
def read_set(
    path: str | PathLike[str] | Sequence[str | PathLike[str]],
    *,
    actuator: str = "",
    progress: Progress = None,
) -> Set: ...
def write_set(path: str | PathLike[str], set: Mapping[str, Any]) -> None: ...
def read_ratings(
    path: str | PathLike[str], names: Sequence[str] | None = None, scale: str = "guess"
) -> Ratings: ...
