"""Texts of others in what is logged and told."""

LONGEST = 300
"""Characters of a text that are told, so that a name of a megabyte does not fill the log."""


def cut(text: str) -> str:
    """Return a text, or its beginning with the number of characters that are left out."""
    if len(text) <= LONGEST:
        return text
    return f'{text[:LONGEST]}... ({len(text) - LONGEST} characters more)'
