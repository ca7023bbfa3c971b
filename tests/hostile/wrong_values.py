"""Values that no setting should have, as a person or an attacker might write them in YAML."""

from hypothesis import settings
from hypothesis import strategies as st

NUMBERS = (
    'nan', '.nan', '.inf', '-.inf', '1e400', '-1e400', '1e300', '-1', '-1e-300', '1e30',
    '1000000000', '18446744073709551616', '-9223372036854775809', '9' * 400, '9' * 5000,
)  # fmt: skip
TEXTS = (
    '', '~', 'null', 'true', 'none', '[', '[1', ']', '{', '{a: ', '[]', '{}', '[1, 2]', '"', "'",
    '!!float x', '!!int ""', '!!int x', '!!bool x', '!!timestamp x', '!!binary x', '!!set {a, b}',
    '!!python/object:x', '!!python/object/apply:os.system [ls]', '!!omap [a]', '!!pairs [a]',
    '!unknown x', '&a [*a]', '*a', '<<: 1', '? [a]', '[' * 3000, '{a: ' * 500, '- ' * 500,
    '../../etc', '/dev/null', '2020-99-99', '0b', '0x', '1:99', '1_', '%YAML 9.9', '---\n---',
    '\x07', '\x00', '\x1b[2J', '\u2028', '\ufeff', '\ud800', 'ä' * 2000, 'a: b: c', '\t', '|', '>',
)  # fmt: skip

wrong_texts = st.sampled_from((*NUMBERS, *TEXTS)) | st.text(max_size=30)
"""YAML of a value: most of it is wrong for every setting."""


def trials(count):
    """Return hypothesis' settings for so many trials, the same in every run."""
    return settings(max_examples=count, derandomize=True, deadline=None, database=None)
