#!/usr/bin/env python3
"""How near the shipped motions come to what was observed.

    tests/shipped_motions.py build/release/bin/dougong [FIGURE.png]

prints the tables of docs/records.md (shipped components, thirty further seeds of the same rupture, and the
Tohoku rupture seen from fourteen stations, with durations and Arias intensity at two), and draws their figure with gnuplot.
"""
import concurrent.futures
import json
import math
import statistics
import subprocess
import sys
import tempfile

from stochastic_ensembles import G, rows, run

SEEDS, STATION_SEEDS = 30, 6
PERIODS = [0.1, 0.15, 0.2, 0.3, 0.4, 0.5, 0.7, 1.0, 1.5, 2.0, 3.0]


def mean(a, b):
    return math.sqrt(a * b)


# Figures of one component, or the geometric mean of two; SI. A shape has figures over its peak.
CASES = [
    {"alias": "wenchuan", "name": "Wenchuan 2008, Bajiao (shape)",
     "observed": {"PGV/PGA": 0.116, "Arias/PGA²": 0.543, "D5-75": 24.0, "D5-95": 89.9, "mean period": 0.353,
                  "psa/PGA": {0.2: 3.08, 0.5: 2.36, 1.0: 0.954, 2.0: 0.394}}},
    {"alias": "tohoku", "name": "Tohoku 2011, MYG010 (durations: MYG004)",
     "observed": {"PGA": mean(0.38, 0.47) * G, "PGV": mean(0.48, 0.58), "D5-75": 52.1, "D5-95": 80.8,
                  "psa": {0.3: mean(0.89, 0.94) * G, 1.0: mean(0.74, 0.50) * G, 3.0: mean(0.096, 0.16) * G}}},
    {"alias": "kobe", "name": "Kobe 1995, KJMA (larger component; D5-95, mean period: Nishi-Akashi)",
     "observed": {"PGA": 0.82 * G, "PGV": 0.813, "D5-95": 9.7, "mean period": 0.495,
                  "psa": {0.3: 2.66 * G, 1.0: 1.36 * G, 3.0: 0.17 * G}}},
    {"alias": "kocaeli", "name": "Kocaeli 1999, Duzce",
     "observed": {"PGA": mean(0.36, 0.31) * G, "PGV": mean(0.54, 0.41)}},
    {"alias": "elcentro", "name": "Imperial Valley 1940, El Centro NS",
     "observed": {"PGA": 3.127, "PGV": 0.36, "Arias": 1.80, "D5-95": 23.8, "mean period": 0.533,
                  "psa": {0.2: 7.775, 1.0: 4.455}}},
]

# Latitude, longitude; PGA (% g), PGV (cm/s), PSa at 0.3, 1 and 3 s (% g), geometric means of east and north:
# USGS ShakeMap of the main shock.
STATIONS = [("MYG004", 38.729, 141.022, 129, 56, 188, 35, 23, 275, 94, 612, 50, 14),
            ("MYG012", 38.318, 141.019, 201, 67, 192, 66, 5.3, 77, 33, 119, 47, 4.5),
            ("IBR003", 36.592, 140.645, 121, 54, 319, 21, 2.6, 163, 67, 633, 37, 6.6),
            ("MYG013", 38.266, 140.929, 100, 49, 133, 59, 11, 155, 75, 155, 166, 18),
            ("IBR013", 36.159, 140.489, 109, 67, 489, 60, 11, 138, 61, 478, 48, 16),
            ("FKS016", 37.123, 140.191, 97, 43, 247, 30, 5.8, 132, 59, 398, 54, 8.0),
            ("TCG009", 36.726, 139.716, 121, 46, 351, 26, 3.5, 104, 43, 395, 19, 3.2),
            ("IWT010", 38.933, 141.117, 87, 40, 185, 33, 6.0, 102, 45, 208, 52, 9.7),
            ("MYGH10", 37.941, 140.892, 87, 47, 118, 45, 14, 89, 60, 315, 48, 34),
            ("MYG010", 38.428, 141.281, 38, 48, 89, 74, 9.6, 47, 58, 94, 50, 16),
            ("FKSH14", 37.026, 140.970, 39, 55, 140, 92, 17, 36, 62, 70, 90, 17),
            ("TKY007", 35.711, 139.686, 17, 21, 62, 16, 9.0, 20, 23, 58, 21, 7.0),
            ("KNG009", 35.442, 139.362, 12, 13, 30, 13, 3.9, 15, 15, 40, 16, 2.8),
            ("TKYH12", 35.670, 139.265, 11, 16, 28, 17, 2.0, 16, 14, 45, 12, 2.3)]
# Calculated from the recordings: of MYG004 the NS component, of TKYH12 the geometric mean of two; SI.
RECORDINGS = [("MYG004", 38.729, 141.022, {"PGA": 27.0, "Arias": 131.5, "D5-75": 52.1, "D5-95": 80.8}),
              ("TKYH12", 35.670, 139.265, {"PGA": mean(1.059, 1.572), "Arias": mean(0.383, 0.830),
                                           "D5-75": mean(50.1, 45.9), "D5-95": mean(65.1, 61.0)})]
STATION_MEASURES = ["PGA", "PGV", "psa0.3", "psa1.0", "psa3.0"]


def measures(program, folder, source, component):
    """Conditioned: a stochastic motion has no meaning below its low cut."""
    choice = [source, *(["--component", component] if component else [])]
    groups = run(program, folder, "record", "measure", *choice, "--condition")["groups"]
    group = next(g for g in groups if component is None or f"/ {component}," in g["of"])
    values = {m["name"]: m["value"] for m in group["measures"]}
    spectrum = run(program, folder, "record", "spectrum", *choice, "--periods", ",".join(f"{t} s" for t in PERIODS))
    for period, psa in zip(PERIODS, spectrum["columns"]["psa_m_s2"]):
        values[f"psa{period}"] = psa
        values[f"psa/PGA{period}"] = psa / values["PGA"]
    values["PGV/PGA"] = values["PGV"] / values["PGA"]
    values["Arias/PGA²"] = values["Arias"] / values["PGA"] ** 2
    return values


def realisation(program, folder, alias, seed, place=None):
    sets = [f"name={alias}", f"seed={seed}"]
    if place:
        sets += [f"site-east={place[0]:.4f} km", f"site-north={place[1]:.4f} km"]
    name = f"{alias}-{seed}-{hash(place)}.at2"
    run(program, folder, "record", "make", "styled", *(w for s in sets for w in ("--set", s)), "--out", name, "--force")
    return measures(program, folder, name, None)


def on_the_map(latitude, longitude):
    """km from the epicentre of the Tohoku rupture's map."""
    degree = 111.195
    return ((longitude - 142.861) * degree * math.cos(math.radians(38.1035)), (latitude - 38.1035) * degree)


def station_table(program, folder, pool):
    print("\n| stations | " + " | ".join(["PGA", "PGV", "PSa at 0.3 s", "1 s", "3 s"]) + " |\n|---|---|---|---|---|---|")
    logs = []
    for name, latitude, longitude, *seen in STATIONS:
        place = on_the_map(latitude, longitude)
        made = list(pool.map(lambda seed: realisation(program, folder, "tohoku", seed, place), range(1, STATION_SEEDS + 1)))
        factors = [G / 100, 0.01, G / 100, G / 100, G / 100]
        logs.append([math.log(mean(seen[i], seen[i + 5]) * f / statistics.median(m[key] for m in made))
                     for i, (key, f) in enumerate(zip(STATION_MEASURES, factors))])
    for label, part in (("all fourteen", logs), ("every second, from the first", logs[::2]), ("the others", logs[1::2])):
        cells = [f"{statistics.mean(c):+.2f} ± {statistics.stdev(c):.2f}" for c in zip(*part)]
        print(f"| {label} | " + " | ".join(cells) + " |")


def duration_table(program, folder, pool):
    print("\n| station | measure | recorded | median of six | recorded/median |\n|---|---|---|---|---|")
    for name, latitude, longitude, seen in RECORDINGS:
        place = on_the_map(latitude, longitude)
        made = list(pool.map(lambda seed: realisation(program, folder, "tohoku", seed, place), range(1, STATION_SEEDS + 1)))
        for measure, value in seen.items():
            median = statistics.median(m[measure] for m in made)
            print(f"| {name} | {measure} | {value:.3g} | {median:.3g} | {value / median:.2f} |")


def history(program, folder, alias):
    run(program, folder, "record", "process", alias, "--out", f"{alias}.csv", "--force")
    lines = open(f"{folder}/{alias}.csv", encoding="utf8").read().split()[1:]
    return "\n".join(line.replace(",", " ") for line in lines[::2])


def draw(program, figure, folder, panels):
    script = ("set encoding utf8\nset terminal pngcairo size 1800,1100 font 'Arial,10' fontscale 2 linewidth 2\n"
              f"set output '{figure}'\nset multiplot layout 2,3\nset border 0\nset tics scale 0\n"
              "set grid lc rgb '#e2e2e2' lw 0.7\nunset key\n")
    for case, _, _ in panels:
        script += (f"$h << EOD\n{history(program, folder, case['alias'])}\nEOD\nset title \"{case['alias'].title()}-style, EW\"\n"
                   "set xlabel 'Time (s)'\nset ylabel 'Acceleration, a (m/s²)'\nset yrange [-10:10]\n"
                   "plot $h with lines lw 0.6 lc rgb '#0072b2'\n")
    script += ("set logscale xy\nset xrange [0.09:3.3]\nset xtics (0.1,0.2,0.5,1,2)\nset xlabel 'Period, T (s)'\n"
               "set key bottom left Left reverse samplen 1.5 spacing 0.9\n")
    for case, shipped, ensemble in panels:
        shape = "psa/PGA" in case["observed"]
        key, unit = ("psa/PGA", 1.0) if shape else ("psa", G)
        band = "\n".join(
            f"{t} " + " ".join(str(q / unit) for q in statistics.quantiles([v[f"{key}{t}"] for v in ensemble], n=100,
                                                                          method="inclusive")[15:84:34]) + " "
            + " ".join(str(v[f"{key}{t}"] / unit) for v in shipped) for t in PERIODS)
        seen = "\n".join(f"{t} {v / unit}" for t, v in case["observed"][key].items())
        script += (f"$e << EOD\n{band}\nEOD\n$o << EOD\n{seen}\nEOD\nset title \"{case['name'].split(' (')[0]}\"\n"
                   f"set ylabel '{'PSa/PGA (-)' if shape else 'PSa, 5 % (g)'}'\nset yrange [0.02:{10 if shape else 6}]\n"
                   "plot $e using 1:2:4 with filledcurves fc rgb '#cfe3f1' title '16 to 84 % of 30 seeds', "
                   "$e using 1:5 with lines lw 1.5 lc rgb '#0072b2' title 'shipped EW', "
                   "$e using 1:6 with lines lw 1.5 lc rgb '#009e73' title 'shipped NS', "
                   "$o with points pt 7 ps 1.4 lc rgb '#d55e00' title 'recorded'\nunset key\n")
    subprocess.run(["gnuplot"], input=script + "unset multiplot\n", text=True, check=True, cwd=folder)


def main():
    program = subprocess.run(["realpath", sys.argv[1]], capture_output=True, text=True, check=True).stdout.strip()
    print("| earthquake and station | measure | recorded | shipped EW, NS | median of 30 | spread, ln | recorded/median |")
    print("|---|---|---|---|---|---|---|")
    panels = []
    with tempfile.TemporaryDirectory() as folder, concurrent.futures.ThreadPoolExecutor(2) as pool:
        for case in CASES:
            shipped = [measures(program, folder, case["alias"], c) for c in ("EW", "NS")]
            ensemble = list(pool.map(lambda seed: realisation(program, folder, case["alias"], seed), range(1, SEEDS + 1)))
            panels.append((case, shipped, ensemble))
            both = [list(rows(case, [one, one])) for one in shipped]
            for i, (label, seen, median, spread, off) in enumerate(rows(case, ensemble)):
                head = case["name"] if i == 0 else "same"
                print(f"| {head} | {label} | {seen:.3g} | {both[0][i][2]:.3g}, {both[1][i][2]:.3g} | {median:.3g} | "
                      f"{spread:.2f} | {math.exp(off):.2f} |", flush=True)
        if len(sys.argv) > 2:
            figure = subprocess.run(["realpath", sys.argv[2]], capture_output=True, text=True).stdout.strip()
            draw(program, figure, folder, panels[:3])
        station_table(program, folder, pool)
        duration_table(program, folder, pool)


if __name__ == "__main__":
    main()
