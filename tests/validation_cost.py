#!/usr/bin/env python3
"""Measures what the cases of docs/validation.md cost and writes the table's last column.

    tests/validation_cost.py [BUILD] [CASE ...]

Runs the tests of every row (or of the named cases, E01 R03 ...) with the release build, one filter at a time, and
takes the processor time of the program, user and system. A filter that several rows name is run once: the rows after
the first say "same".
"""
import os
import re
import resource
import subprocess
import sys

ROOT = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
DOCUMENT = os.path.join(ROOT, "docs", "validation.md")
HEADER = "| case | what it checks |"
COLUMN = "cost (s)"


def cells_of(line):
    return [cell.strip() for cell in line.strip().strip("|").split("|")]


def row_of(cells):
    return "|" + "|".join(f" {cell} " if cell else " " for cell in cells) + "|\n"


def commands_of(cell, build):
    """Programs and their filters: "`test_study`: `A.*`; `test_cli`: `B.*`", or "`A.*`, `B.*`" of test_engine."""
    filters = {}
    program = "test_engine"
    for name in re.findall(r"`([^`]+)`", cell):
        if name.startswith("test_"):
            program = name
        elif "/" not in name and not name.endswith("_bench"):  # a bench is not run: what it costs is written by hand
            filters.setdefault(program, []).append(name)
    return [[os.path.join(build, "bin", program), "--gtest_filter=" + ":".join(names)]
            for program, names in filters.items()]


def processor_time(command):
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    run = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    if run.returncode != 0 or "Running 0 tests" in run.stdout:
        sys.exit("failed, or runs no test: " + " ".join(command))
    return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime


def written(seconds):
    return "0.01" if seconds < 0.01 else f"{seconds:.2g}" if seconds < 10 else f"{seconds:.0f}"


def with_costs(rows, build, cases):
    measured = set()
    for cells in rows:
        commands = commands_of(cells[2], build)
        if not commands and cells[2] != "same":
            continue
        key = tuple(map(tuple, commands))
        if not commands or key in measured:
            cells[-1] = "same"
            continue
        measured.add(key)
        if not cases or cells[0] in cases:
            cells[-1] = written(sum(map(processor_time, commands)))
            print(cells[0], *(command[1] for command in commands), cells[-1], flush=True)
    return rows


def main(build="build/release", *cases):
    build = os.path.join(ROOT, build)
    with open(DOCUMENT, encoding="utf-8") as file:
        lines = file.readlines()
    first = next(i for i, line in enumerate(lines) if line.startswith(HEADER))
    last = next(i for i in range(first, len(lines)) if not lines[i].strip())
    rows = [cells_of(line) for line in lines[first:last]]
    if rows[0][-1] != COLUMN:
        for cells, end in zip(rows, [COLUMN, "---"] + [""] * len(rows)):
            cells.append(end)
    rows[2:] = with_costs(rows[2:], build, cases)
    rule = "|" + "---|" * len(rows[0]) + "\n"
    lines[first:last] = [row_of(rows[0]), rule] + [row_of(cells) for cells in rows[2:]]
    with open(DOCUMENT, "w", encoding="utf-8") as file:
        file.writelines(lines)


if __name__ == "__main__":
    main(*sys.argv[1:])
