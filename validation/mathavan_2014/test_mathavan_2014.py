import pytest
from carom.validation.mathavan_2014 import rows
from carom.validation.row import Row, check, rows_of


@pytest.mark.parametrize("row", rows_of(rows), ids=str)
def test_mathavan_2014(row: Row) -> None:
    check(row)
