import pytest
from carom.validation.han_2005 import rows
from carom.validation.row import Row, check, rows_of


@pytest.mark.parametrize("row", rows_of(rows), ids=str)
def test_han_2005(row: Row) -> None:
    check(row)
