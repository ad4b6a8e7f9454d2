# One clock, ideal; inputs arrive with it and outputs are wanted by it. $library, $netlist and $top
# are set by tools/synth/timing.py, which also takes what is printed apart.
# SPDX-License-Identifier: Apache-2.0
read_liberty $library
read_verilog $netlist
link_design $top
create_clock -name clk -period 10 [get_ports clk]
foreach port [all_inputs] {
  if {[get_property $port full_name] != "clk"} { set_input_delay 0 -clock clk $port }
}
set_output_delay 0 -clock clk [all_outputs]
set_load 0.02 [all_outputs]
report_checks -path_delay max -digits 4
set_power_activity -global -activity 0.2 -duty 0.5
report_power -digits 6
