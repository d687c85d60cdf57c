"""The complete programs of docs/coming_from.md, and the commands with which the page builds and runs them."""

import pathlib
import sys

sys.dont_write_bytecode = True
sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "docs"))

from markdown import read_document


def write_snippets(root, folder):
    """Writes the page's files into the folder; returns its commands, each of which prints one distance at last."""
    commands = []
    for block in read_document(pathlib.Path(root), "docs/coming_from.md").blocks:
        for _, text in block.directives:
            if text.startswith("file "):
                (pathlib.Path(folder) / text[len("file ") :]).write_text(block.text)
            elif text == "prints the distance":
                commands.append(block.text.strip())
    if len(commands) != 3:
        sys.exit("docs/coming_from.md has %d commands that print the distance, expected 3" % len(commands))
    return commands


def require_one_distance(outputs):
    """Fails unless the last lines of all outputs are one number, above 0, with all its digits."""
    lines = [output.strip().splitlines()[-1] for output in outputs]
    if len(set(lines)) != 1 or not float(lines[0]) > 0 or len(lines[0]) < 15:
        sys.exit("the programs of docs/coming_from.md print %s, expected one distance with all its digits" % lines)
    return lines[0]
