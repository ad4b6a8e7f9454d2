"""The modules of synth/TARGET, which take the place of those of the RTL, are equal to them.

Both are read with the model of the target's cell, and joined; where they are the same, all that is
left of both after equal registers and equal operators have been merged is one answer: equal.
"""

import subprocess

import pytest

from tools.project_root import ROOT

OWN = "synth/ecp5/ffd_fx_block.v"
CELL = "tb/cells/ecp5/MULT18X18D.v"
SHARED = "rtl/common/ffd_num_delay.v"
RTL = "rtl/number/fixed/ffd_fx_block.v"


def equal(own, *parameters):
    """Whether both modules, with these parameters, are one."""
    values = " ".join(f"-set {name} {value}"
                      for name, value in zip(("W", "BEFORE", "BEHIND"), parameters))

    def side(name, *files):
        return (f"read_verilog {' '.join(map(str, files))}; chparam {values} ffd_fx_block; "
                f"hierarchy -top ffd_fx_block; proc; flatten; opt -full; wreduce; opt -full; "
                f"rename -top {name}; design -stash {name}; ")

    steps = (side("gold", SHARED, RTL) + side("gate", SHARED, own, CELL)
             + "design -copy-from gold gold; design -copy-from gate gate; "
             "miter -equiv -flatten -make_assert gold gate joined; hierarchy -top joined; "
             "opt -full; simplemap t:$dff; opt_merge; opt_clean; wreduce; opt -full; opt_merge; "
             "opt -full; select -assert-count 1 t:*; select -assert-count 1 t:$assert; "
             "sat -prove-asserts -verify joined")
    result = subprocess.run(["yosys", "-Q", "-T", "-p", steps], cwd=ROOT, text=True,
                            capture_output=True, check=False)
    left_over = "select -assert-count 1 t:*" in result.stderr or "Assertion failed" in result.stderr
    assert result.returncode == 0 or left_over, result.stdout[-2000:] + result.stderr
    return result.returncode == 0


@pytest.mark.parametrize("width", (3, 12, 18))
@pytest.mark.parametrize("before, behind", ((0, 0), (0, 1), (1, 1), (2, 1), (1, 2), (2, 3)))
def test_a_block_of_ecp5_is_the_module_of_the_rtl(width, before, behind):
    assert equal(ROOT / OWN, width, before, behind)


def test_wider_products_are_left_to_the_synthesis():
    assert equal(ROOT / OWN, 20, 1, 1)


@pytest.mark.parametrize("right, wrong", (
    ('.REG_OUTPUT_CLK  (BEHIND > 0 ?', '.REG_OUTPUT_CLK  (BEHIND > 1 ?'),
    ('.REG_INPUTB_CLK  (BEFORE > 0 ?', '.REG_INPUTB_CLK  (BEFORE > 1 ?'),
    (".SIGNEDA(1'b1)", ".SIGNEDA(1'b0)"),
    (".P17(block_p[17])", ".P17(block_p[16])"),
    ("BEFORE - 1 : BEFORE", "BEFORE : BEFORE")))
def test_faults_are_found(tmp_path, right, wrong):
    text = (ROOT / OWN).read_text()
    assert text.count(right) == 1
    faulty = tmp_path / "ffd_fx_block.v"
    faulty.write_text(text.replace(right, wrong))
    assert not equal(faulty, 18, 1, 1)
