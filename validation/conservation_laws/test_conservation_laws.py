import pytest
from carom.validation.conservation_laws import rows
from carom.validation.row import Row, check, rows_of


@pytest.mark.parametrize("row", rows_of(rows), ids=str)
def test_conservation_laws(row: Row) -> None:
    check(row)
