import pytest
from carom.validation.row import Row, check, rows_of
from carom.validation.unf_jump_machine import rows


@pytest.mark.parametrize("row", rows_of(rows), ids=str)
def test_unf_jump_machine(row: Row) -> None:
    check(row)
