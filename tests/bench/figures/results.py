"""Reads the measured tables of one machine, and writes numbers as the documents show them."""

import csv
import math
import statistics


class NotMeasured(Exception):
    """A table, or a row of it, that no run has written yet."""


class Results:
    """The tables of one folder of tests/bench/results. Each is read once."""

    def __init__(self, folder):
        self.folder = folder
        self.tables = {}

    def rows(self, name):
        """The rows of NAME.csv as dictionaries; throws NotMeasured if there are none."""
        if name not in self.tables:
            self.tables[name] = read(self.folder / f"{name}.csv")
        if not self.tables[name]:
            raise NotMeasured(f"{name}.csv")
        return self.tables[name]

    def has(self, name):
        return (self.folder / f"{name}.csv").exists()

    def select(self, name, **values):
        """The rows that have these values in these columns; throws NotMeasured if there are none."""
        found = matching(self.rows(name), **values)
        if not found:
            raise NotMeasured(f"{name}.csv, {', '.join(f'{column} {value}' for column, value in values.items())}")
        return found

    def row(self, name, **values):
        found = self.select(name, **values)
        if len(found) > 1:
            raise ValueError(f"{name}.csv has {len(found)} rows with {values}, expected one")
        return found[0]


def read(file):
    """The rows of a table; none if there is no file."""
    if not file.exists():
        return []
    with open(file, newline="") as table_file:
        return list(csv.DictReader(table_file))


def matching(rows, **values):
    return [row for row in rows if all(row[column] == value for column, value in values.items())]


def distinct(rows, column):
    """The values of a column, each once, in the table's order."""
    return list(dict.fromkeys(row[column] for row in rows))


def numbers(rows, column):
    return [float(row[column]) for row in rows if row[column] != ""]


def shown(value):
    """Two significant digits below 10, one decimal below 20, whole numbers with thousands apart above."""
    value = float(value)
    if not math.isfinite(value):
        return "-"
    if value < 0:
        return "-" + shown(-value)
    if value == 0:
        return "0"
    if value < 9.95:
        rounded = float(f"{value:.2g}")
        if rounded < 1e-4:
            return f"{rounded:.1e}".replace("e-0", "e-")
        return f"{rounded:.{max(0, 1 - math.floor(math.log10(rounded)))}f}"
    return f"{value:.1f}" if value < 19.95 else f"{value:,.0f}"


def seconds(value):
    return "< 0.01" if float(value) < 0.01 else shown(value)


def percent(share):
    """A share as a percentage: whole numbers, or one digit below 1 %."""
    hundredths = 100 * float(share)
    return f"{shown(hundredths) if abs(hundredths) < 1 else f'{hundredths:.0f}'} %"


def whole(value):
    return f"{int(float(value)):,}"


def span(values, write=shown):
    """From the least to the largest value; one number if both read alike, nothing without values."""
    if not values:
        return ""
    low, high = write(min(values)), write(max(values))
    return low if low == high else f"{low} to {high}"


def median_with_range(values, write=shown):
    """The median, with the least and the largest value behind it."""
    if not values:
        return ""
    if write(min(values)) == write(max(values)):
        return write(values[0])
    return f"{write(statistics.median(values))} ({write(min(values))} to {write(max(values))})"


def table(head, rows):
    """A Markdown table."""
    return ["| " + " | ".join(head) + " |", "|" + "---|" * len(head)] + ["| " + " | ".join(row) + " |" for row in rows]
