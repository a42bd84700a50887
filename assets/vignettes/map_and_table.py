"""Which metric agrees with people, and where the patterns lie: the program's numbers in Python.

    app/run python assets/vignettes/map_and_table.py SET [MAP.png [RATINGS]]

SET is a set of patterns, such as assets/sets/morse_rothkopf_1957.tactspace.json, which brings along
what 598 people said who heard it; RATINGS a file or a folder of other ratings. Prints the layout of
Table 2 in Lim & Park 2023, as `tactspace compare --paper-mode` does, and draws the map with matplotlib
(python3-matplotlib).
"""

import sys

import tactspace


def digits(number):
    return "-" if number != number else f"{number:.2f}"  # NaN: undefined


def print_table(given, ratings):
    if ratings["synthetic"]:
        print("SYNTHETIC: some or all of these ratings were given by nobody")
    print(f"{'metric':15}{'rho':>6}{'K':>6}")
    distances = {metric: tactspace.predict(given["waves"], metric, model=given["model"])
                 for metric in tactspace.metrics}
    for metric, agreement in tactspace.compare(distances, ratings).items():
        print(f"{metric:15}{digits(agreement['rho']):>6}{digits(agreement['K_paper']):>6}")


def draw_map(names, points, stress, file):
    try:
        import matplotlib
    except ModuleNotFoundError:
        print("no map is drawn: python3-matplotlib is not installed")
        return
    matplotlib.use("Agg")  # a file, no window
    from matplotlib import pyplot

    figure, axes = pyplot.subplots(figsize=(6, 6), layout="constrained")
    axes.scatter(points[:, 0], points[:, 1])
    for name, (x, y) in zip(names, points):
        axes.annotate(name, (x, y), xytext=(4, 4), textcoords="offset points", fontsize=8)
    axes.set_aspect("equal")
    axes.set(title=f"predicted perceptual space, stress-1 {stress:.3f}", xticks=[], yticks=[])
    figure.savefig(file, dpi=150)


def main(set_path, picture=None, ratings_path=None):
    given = tactspace.read_set(set_path)
    print(given["name"])
    distances = tactspace.predict(given["waves"], model=given["model"])
    count = min(8, len(distances))
    most = tactspace.subset(distances, count, keep=given["locked"], drop=given["dropped"])
    print("most distinct:", ", ".join(given["names"][k] for k in most["members"]))
    if picture:
        draw_map(given["names"], *tactspace.space(distances, dimensions=2), picture)
    ratings = tactspace.read_ratings(ratings_path, given["names"]) if ratings_path else given["ratings"]
    if ratings:
        print_table(given, ratings)


if __name__ == "__main__":
    if not 2 <= len(sys.argv) <= 4:
        sys.exit(__doc__)
    main(*sys.argv[1:])
