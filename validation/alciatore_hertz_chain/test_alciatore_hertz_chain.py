import pytest
from carom.validation.row import Row, check, rows_of
from carom.validation.alciatore_hertz_chain import rows


@pytest.mark.parametrize("row", rows_of(rows), ids=str)
def test_alciatore_hertz_chain(row: Row) -> None:
    check(row)
