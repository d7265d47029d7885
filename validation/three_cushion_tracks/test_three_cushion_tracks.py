import pytest
from carom.validation.row import Row, check, rows_of
from carom.validation.three_cushion_tracks import rows


@pytest.mark.parametrize("row", rows_of(rows), ids=str)
def test_a_row_is_as_declared(row: Row) -> None:
    check(row)
