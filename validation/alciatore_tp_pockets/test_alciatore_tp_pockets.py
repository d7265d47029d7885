import pytest
from carom.validation.alciatore_tp_pockets import rows
from carom.validation.row import Row, check, rows_of


@pytest.mark.parametrize("row", rows_of(rows), ids=str)
def test_alciatore_tp_pockets(row: Row) -> None:
    check(row)
