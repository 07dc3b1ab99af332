#!/usr/bin/env python3
"""How near stochastic finite faults come to what was observed: thirty seeds of each of three earthquakes.

    tests/stochastic_ensembles.py build/release/bin/dougong [FIGURE.png]

prints the table of docs/records.md, and draws its figure with gnuplot. The crust, stress drop and site are the
same for all three: nothing is fitted to a station.
"""
import json
import math
import statistics
import subprocess
import sys
import tempfile

SEEDS = 30
G = 9.80665
CRUST = {"stress-drop": "8 MPa", "kappa": "0.04 s", "site-factor": "1.5", "slip": "random"}
PERIODS = [0.1, 0.2, 0.3, 0.5, 1.0, 2.0, 3.0]

# Sources and observed figures: seismic/synthesis/finite_fault.h has the axes (strike 0, dip to the east).
# Figures of one component, SI; a shape has figures over its peak.
CASES = [
    {"name": "Imperial Valley 1940, El Centro NS", "place": "6 km from 63 x 13 km, Mw 6.95",
     "fault": {"magnitude": "6.95", "length": "63 km", "width": "13 km", "dip": "80 deg", "subfault-length": "3 km",
               "subfault-width": "3 km", "hypocentre-along": "0.5", "site-east": "-6 km", "site-north": "43 km"},
     "observed": {"PGA": 3.127, "PGV": 0.36, "Arias": 1.80, "D5-95": 23.8, "mean period": 0.533,
                  "psa": {0.2: 7.775, 1.0: 4.455}}},
    {"name": "Kobe 1995, Nishi-Akashi", "place": "6.7 km from 59 x 20 km, Mw 6.9",
     "fault": {"magnitude": "6.9", "length": "59 km", "width": "20 km", "dip": "85 deg", "subfault-length": "4 km",
               "subfault-width": "4 km", "hypocentre-along": "0.4", "hypocentre-down": "0.8", "site-east": "-6.7 km",
               "site-north": "20 km"},
     "observed": {"PGA": 0.51 * G, "PGV": 0.37, "D5-95": 9.7, "mean period": 0.495,
                  "psa": {0.3: 1.09 * G, 1.0: 0.35 * G, 3.0: 0.078 * G}}},
    {"name": "Wenchuan 2008, Bajiao (shape)", "place": "15 km from 300 x 40 km, Mw 7.9",
     "fault": {"magnitude": "7.9", "length": "300 km", "width": "40 km", "dip": "33 deg", "subfault-length": "10 km",
               "subfault-width": "5 km", "hypocentre-along": "0.1", "hypocentre-down": "0.5", "site-east": "-15 km",
               "site-north": "80 km"},
     "observed": {"PGV/PGA": 0.116, "D5-75": 24.0, "D5-95": 89.9, "mean period": 0.353,
                  "psa/PGA": {0.2: 3.08, 0.5: 2.36, 1.0: 0.954, 2.0: 0.394}}},
]


def run(program, folder, *words):
    return json.loads(subprocess.run([program, *words, "--json"], cwd=folder, check=True, capture_output=True,
                                     text=True).stdout)


def one(program, folder, case, seed):
    keys = {**CRUST, **case["fault"], "seed": str(seed)}
    sets = [word for key, value in keys.items() for word in ("--set", f"{key}={value}")]
    run(program, folder, "record", "make", "finite-fault", *sets, "--out", "m.at2", "--force")
    # Conditioned: a stochastic motion has no meaning below its low cut.
    groups = run(program, folder, "record", "measure", "m.at2", "--condition")["groups"]
    values = {m["name"]: m["value"] for m in groups[0]["measures"]}
    spectrum = run(program, folder, "record", "spectrum", "m.at2", "--periods", ",".join(f"{t} s" for t in PERIODS))
    for period, psa in zip(PERIODS, spectrum["columns"]["psa_m_s2"]):
        values[f"psa{period}"] = psa
        values[f"psa/PGA{period}"] = psa / values["PGA"]
    values["PGV/PGA"] = values["PGV"] / values["PGA"]
    return values


def rows(case, ensemble):
    for name, seen in case["observed"].items():
        for period, value in (seen.items() if isinstance(seen, dict) else [(None, seen)]):
            key = name if period is None else f"{name}{period}"
            label = name if period is None else f"{name.replace('psa', 'PSa')} at {period} s"
            logs = sorted(math.log(v[key]) for v in ensemble)
            median, spread = statistics.median(logs), statistics.stdev(logs)
            yield label, value, math.exp(median), spread, math.log(value) - median


def draw(figure, folder, panels):
    script = ("set encoding utf8\nset terminal pngcairo size 1800,640 font 'Arial,10' fontscale 2 linewidth 2\n"
              f"set output '{figure}'\nset multiplot layout 1,3\nset logscale xy\nset xrange [0.08:4]\n"
              "set xtics (0.1,0.2,0.5,1,2)\nset border 0\nset tics scale 0\nset grid lc rgb '#e2e2e2' lw 0.7\n"
              "set key bottom left samplen 1.5\nset xlabel 'Period, T (s)'\n")
    for case, ensemble in panels:
        shape = "psa/PGA" in case["observed"]
        key, unit = ("psa/PGA", 1.0) if shape else ("psa", G)
        data = "\n".join(
            f"{t} " + " ".join(str(q / unit) for q in statistics.quantiles([v[f"{key}{t}"] for v in ensemble], n=100,
                                                                          method="inclusive")[15:84:34])
            for t in PERIODS)
        seen = "\n".join(f"{t} {v / unit}" for t, v in case["observed"][key].items())
        script += (f"$e << EOD\n{data}\nEOD\n$o << EOD\n{seen}\nEOD\nset title \"{case['name']}\"\n"
                   f"set ylabel '{'PSa/PGA (-)' if shape else 'PSa, 5 % (g)'}'\nset yrange [{0.1 if shape else 0.02}:{10 if shape else 3}]\n"
                   "plot $e using 1:2:4 with filledcurves fc rgb '#cfe3f1' title '16 to 84 % of 30 seeds', "
                   "$e using 1:3 with lines lw 2 lc rgb '#0072b2' title 'median', "
                   "$o with points pt 7 ps 1.4 lc rgb '#d55e00' title 'recorded'\nunset key\n")
    subprocess.run(["gnuplot"], input=script + "unset multiplot\n", text=True, check=True, cwd=folder)


def main():
    program = subprocess.run(["realpath", sys.argv[1]], capture_output=True, text=True, check=True).stdout.strip()
    print("| earthquake and station | measure | recorded | median of 30 | spread, ln | recorded/median |")
    print("|---|---|---|---|---|---|")
    panels = []
    with tempfile.TemporaryDirectory() as folder:
        for case in CASES:
            ensemble = [one(program, folder, case, seed) for seed in range(1, SEEDS + 1)]
            panels.append((case, ensemble))
            for i, (label, seen, median, spread, off) in enumerate(rows(case, ensemble)):
                head = f"{case['name']}; {case['place']}" if i == 0 else "same"
                print(f"| {head} | {label} | {seen:.3g} | {median:.3g} | {spread:.2f} | {math.exp(off):.2f} |")
        if len(sys.argv) > 2:
            figure = subprocess.run(["realpath", sys.argv[2]], capture_output=True, text=True).stdout.strip()
            draw(figure, folder, panels)


if __name__ == "__main__":
    main()
