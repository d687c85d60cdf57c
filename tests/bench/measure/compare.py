"""Shows expected figures, those of the documents' tables, beside measured ones."""

from machine import IDENTITY
from results import shown, table
from tables import read

FAR = 1.15  # a quotient further from 1 than this, and outside the spread of both, is called different


def machine_of(record):
    return ", ".join(f"{name} {record.get(name, 'not known')}" for name in IDENTITY)


def refusal(expected_record, record):
    """Why figures of these two runs are not compared; empty if they are of one machine."""
    if expected_record is None:
        return "the expected figures do not say which machine they are of"
    if any(expected_record.get(name) != record[name] for name in IDENTITY):
        return f"the expected figures are of another machine ({machine_of(expected_record)}) than this one ({machine_of(record)})"
    return ""


def range_of(row, column):
    value = float(row[column])
    return float(row.get(f"{column}_least") or value), float(row.get(f"{column}_largest") or value)


def verdict(expected, measured, column):
    quotient = float(measured[column]) / float(expected[column]) if float(expected[column]) else 1.0
    (low, high), (least, largest) = range_of(expected, column), range_of(measured, column)
    is_far = not 1 / FAR <= quotient <= FAR and (least > high or largest < low)
    return f"{quotient:.2f}" + (", different" if is_far else "")


def with_range(row, column):
    low, high = range_of(row, column)
    value = shown(row[column])
    return value if shown(low) == shown(high) else f"{value} ({shown(low)} to {shown(high)})"


def compare(part, rows, expected_rows, refused):
    """The lines of a table: each figure of the measured rows, with the expected one. refused: why there is no verdict."""
    by_key = {tuple(row[key] for key in part.keys): row for row in expected_rows}
    lines = []
    for row in filter(part.is_shown, rows):
        expected = by_key.get(tuple(row[key] for key in part.keys))
        for column in part.shown:
            if not row.get(column):
                continue
            known = expected is not None and expected.get(column)
            lines.append([", ".join(row[key] for key in part.keys), column, with_range(expected, column) if known else "-",
                          with_range(row, column), verdict(expected, row, column) if known and not refused else "-"])
    return table(["row", "figure", "expected", "measured", "measured / expected"], lines)


def expected_of(part, folder):
    """The rows of the documents' table and the records of their runs; none if it was not measured yet."""
    file = folder / f"{part.name}.csv"
    rows = read(file)[1] if file.exists() else []
    records = read(folder / "runs.csv")[1] if (folder / "runs.csv").exists() else []
    return rows, {record["row"]: record for record in records if record["part"] == part.name}
