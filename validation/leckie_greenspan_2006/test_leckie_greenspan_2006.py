import pytest
from carom.validation.leckie_greenspan_2006 import rows
from carom.validation.row import Row, check, rows_of


@pytest.mark.parametrize("row", rows_of(rows), ids=str)
def test_leckie_greenspan_2006(row: Row) -> None:
    check(row)
