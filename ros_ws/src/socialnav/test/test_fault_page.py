"""The page of what the robot does when something goes wrong is that of the tests."""

from pathlib import Path

from helpers.faults import FAULTS, PAGE, page

TESTS = Path(__file__).parent


def test_the_page_is_written_from_the_table_that_the_tests_go_by():
    assert PAGE.read_text() == page(), 'make docs writes it'


def test_every_row_of_the_table_is_shown_by_a_test():
    files = [path for path in TESTS.rglob('test_*.py') if path != Path(__file__)]
    code = ''.join(path.read_text() for path in files)
    assert [name for name in FAULTS if f"'{name}'" not in code] == []
