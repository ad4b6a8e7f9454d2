"""Runs test_hwffd_axi.py with Icarus Verilog: run.py VECTORS FOLDER.

SPDX-License-Identifier: Apache-2.0
"""

import pathlib
import sys

from cocotb.runner import get_results, get_runner

from tools.rtl import rtl_sources

HERE = pathlib.Path(__file__).resolve().parent


def main(vectors, folder):
    sources = rtl_sources.Sources()
    files = [*sources.files.values(), HERE / "hwffd_axi_ids.v"]
    runner = get_runner("icarus")
    runner.build(verilog_sources=files, includes=sources.includes,
                 defines={rtl_sources.SIMULATION: 1},
                 hdl_toplevel="hwffd_axi_ids", build_args=["-g2005"], build_dir=folder, always=True)
    results = runner.test(hdl_toplevel="hwffd_axi_ids", test_module="test_hwffd_axi",
                          test_dir=HERE, build_dir=folder, extra_env={"VECTORS": vectors},
                          results_xml=str(pathlib.Path(folder) / "results.xml"))
    tests, failures = get_results(results)
    print(f"cocotb: {tests} tests, {failures} failures")
    return 0 if tests > 0 and failures == 0 else 1


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:3]))
