import pytest
from carom.validation.breaks_on_video import rows
from carom.validation.row import Row, check, rows_of


@pytest.mark.parametrize("row", rows_of(rows), ids=str)
def test_a_row_is_as_declared(row: Row) -> None:
    check(row)
