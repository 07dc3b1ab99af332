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


def command_of(cell, build):
    """The program and its filter: "`test_study`: `A.*`", or "`A.*`, `B.*`" of test_engine."""
    named = re.findall(r"`([^`]+)`", cell)
    program = named.pop(0) if named and named[0].startswith("test_") else "test_engine"
    filters = ":".join(name for name in named if "/" not in name)
    return [os.path.join(build, "bin", program), "--gtest_filter=" + filters] if filters else None


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
        command = command_of(cells[2], build)
        key = tuple(command or ())
        if not command or key in measured:
            cells[-1] = "same"
            continue
        measured.add(key)
        if not cases or cells[0] in cases:
            cells[-1] = written(processor_time(command))
            print(cells[0], command[1], cells[-1], flush=True)
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
