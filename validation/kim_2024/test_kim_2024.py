import pytest
from carom.validation.kim_2024 import rows
from carom.validation.row import Row, check, rows_of


@pytest.mark.parametrize("row", rows_of(rows), ids=str)
def test_kim_2024(row: Row) -> None:
    check(row)
