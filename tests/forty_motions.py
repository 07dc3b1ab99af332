#!/usr/bin/env python3
"""One statue under forty motions of one earthquake: which throw it over.

    tests/forty_motions.py build/release/bin/dougong out/statue [FIGURE.png]

makes forty further realisations of the Kobe-style rupture (seeds 1 to 40), compares the statue as it stands with
the same on friction pendulums under all of them (dougong compare, its results in the folder), and draws which motions
overturned it over their peak acceleration and velocity, with gnuplot. docs/studies/statue.md says what comes out.
"""
import csv
import os
import subprocess
import sys

from stochastic_ensembles import G, run

SEEDS = range(1, 41)
STATUE = ["item=statue", "floor_thickness=0 m", "item_width=0.45 m", "pedestal_width=0.6 m"]
AS_IT_STANDS = "isolation = none"


def motions(program, folder):
    made = []
    for seed in SEEDS:
        name = f"kobe-{seed}.at2"
        run(program, folder, "record", "make", "styled", "--set", "name=kobe", "--set", f"seed={seed}", "--out", name,
            "--force")
        measures = run(program, folder, "record", "measure", name, "--condition")["groups"][0]["measures"]
        values = {m["name"]: m["value"] for m in measures}
        made.append((name, values["PGA"] / G, values["PGV"]))
    return made


def compare(program, folder, names):
    sets = [w for value in STATUE for w in ("--set", value)]
    records = [w for name in names for w in ("--record", os.path.join(folder, name))]
    subprocess.run([program, "compare", "--layout", "equipment", *sets, "--vary", "isolation = none, friction-pendulum",
                    *records, "--same-sa", "no", "--set", "ensemble.half_step=false",
                    "--out", os.path.join(folder, "compare"), "--force"], check=True)


def fallen(folder):
    """Names of the records under which the statue as it stands collapsed."""
    with open(os.path.join(folder, "compare", "compare.csv"), encoding="utf8") as file:
        rows = list(csv.DictReader(file))
    return {row["record"] for row in rows if row["variant"] == AS_IT_STANDS and row["verdict"] == "collapsed"}


def draw(figure, points):
    data = {kind: "\n".join(f"{pga} {pgv}" for pga, pgv, down in points if down == kind) or "NaN NaN"
            for kind in (True, False)}
    script = ("set encoding utf8\nset terminal pngcairo size 1280,900 font 'Arial,10' fontscale 2 linewidth 2\n"
              f"set output '{figure}'\n$fell << EOD\n{data[True]}\nEOD\n$stood << EOD\n{data[False]}\nEOD\n"
              "set border 3 lc rgb '#616161'\nset tics nomirror scale 0.4\nset grid lc rgb '#e2e2e2' lw 0.7\n"
              "set xlabel 'Peak ground acceleration (g)'\nset ylabel 'Peak ground velocity (m/s)'\n"
              "set xrange [0:*]\nset yrange [0:*]\nset key outside top center horizontal samplen 1\n"
              "plot $fell with points pt 7 ps 1.6 lc rgb '#d55e00' title 'overturned', "
              "$stood with points pt 6 ps 1.6 lc rgb '#0072b2' title 'stood'\n")
    subprocess.run(["gnuplot"], input=script, text=True, check=True)


def main():
    program, folder = os.path.realpath(sys.argv[1]), sys.argv[2]
    os.makedirs(folder, exist_ok=True)
    made = motions(program, folder)
    compare(program, folder, [name for name, _, _ in made])
    down = fallen(folder)
    points = [(pga, pgv, os.path.splitext(name)[0] in down) for name, pga, pgv in made]
    print(f"\n{sum(p[2] for p in points)} of {len(points)} motions overturn the statue as it stands")
    for kind, label in ((True, "overturned"), (False, "stood")):
        part = [p for p in points if p[2] == kind]
        print(f"{label}: PGA {min(p[0] for p in part):.2f} to {max(p[0] for p in part):.2f} g, "
              f"PGV {min(p[1] for p in part):.2f} to {max(p[1] for p in part):.2f} m/s")
    if len(sys.argv) > 3:
        draw(sys.argv[3], points)


if __name__ == "__main__":
    main()
