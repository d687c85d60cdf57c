"""Finds measured figures that somebody typed into a document in place of a mark."""


def typed_figures(name, text):
    return []
