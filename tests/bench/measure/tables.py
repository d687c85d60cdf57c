"""Reads, merges and writes the measured tables, and makes one table of several repetitions."""

import csv
import os
import statistics


def read(file):
    with open(file, newline="") as table:
        reader = csv.DictReader(table)
        return list(reader.fieldnames or []), list(reader)


def write(file, columns, rows):
    """Replaces the file as a whole, so that nothing is lost when the run is stopped."""
    temporary = file.with_suffix(".tmp")
    with open(temporary, "w", newline="") as table:
        writer = csv.DictWriter(table, columns, lineterminator="\n")
        writer.writeheader()
        writer.writerows(rows)
    os.replace(temporary, file)


def merge(file, columns, rows, keys):
    """Writes the rows into the file. They replace the rows that have equal values in the columns `keys`, with no keys all rows; others
    stay. A table with other columns is replaced as a whole."""
    kept = []
    if file.exists():
        old_columns, old = read(file)
        if old_columns == columns:
            fresh = {tuple(row[key] for key in keys) for row in rows}
            kept = [row for row in old if tuple(row[key] for key in keys) not in fresh]
    write(file, columns, kept + rows)


def median_of(tables, keys, spread):
    """One table of several repetitions of it: medians of the columns `spread`, with their least and largest values in columns of
    their own; the other columns are the first repetition's. keys: the columns that tell which rows belong together."""
    columns, first = tables[0]
    made = list(columns) + ["repetitions"]
    for name in spread:
        made += [f"{name}_least", f"{name}_largest"]
    rows = []
    for row in first:
        key = [row[name] for name in keys]
        same = [other for _, table in tables for other in table if [other[name] for name in keys] == key]
        made_row = dict(row, repetitions=len(same))
        for name in spread:
            values = [float(other[name]) for other in same if other[name] != ""]
            made_row[name] = figure(statistics.median(values)) if values else ""
            made_row[f"{name}_least"] = figure(min(values)) if values else ""
            made_row[f"{name}_largest"] = figure(max(values)) if values else ""
        rows.append(made_row)
    return made, rows


def figure(value):
    return f"{value:.6g}"
