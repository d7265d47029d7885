"""Parameters have names: few functions of Rust have one in a tuple."""

from pathlib import Path

from structure import tuple_parameters

# Most of them take a tuple from Python.
MOST = 10


def test_few_functions_have_a_parameter_in_a_tuple() -> None:
    found = tuple_parameters.functions()
    assert len(found) <= MOST, "give the parameters names: " + "; ".join(found)


def test_finds_tuples_and_references_to_them_only(tmp_path: Path) -> None:
    source = tmp_path / "crates" / "one" / "src"
    source.mkdir(parents=True)
    (source / "lib.rs").write_text(
        """
fn a((x, y): (f64, f64)) {}
fn b<T: Fn(u8, u8) -> u8>(t: T, pair: &mut (u8, u8)) -> (u8, u8) {}
fn c(
    one: u8,
    (two, mut three): (Map<u8, u8>, &[u8]),
) {}
fn d(f: impl Fn((u8, u8)) -> u8, g: Vec<(u8, u8)>, h: [(u8, u8); 2], i: (), j: &dyn Fn(u8, u8)) {}
// fn e((x, y): (f64, f64)) {}
"""
    )
    found = [place.rpartition(" ")[2] for place in tuple_parameters.functions(tmp_path)]
    assert found == ["a", "b", "c"]
