import pytest
from carom.validation.row import Row, check, rows_of
from carom.validation.shepard_1997 import rows


@pytest.mark.parametrize("row", rows_of(rows), ids=str)
def test_shepard_1997(row: Row) -> None:
    check(row)
