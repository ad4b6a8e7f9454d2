# A core by itself, for tools that read SDC; in a design the clock comes from there.
# SPDX-License-Identifier: Apache-2.0
set period 10.0
create_clock -name aclk -period $period [get_ports aclk]
set_input_delay -clock aclk [expr 0.4 * $period] [remove_from_collection [all_inputs] [get_ports aclk]]
set_output_delay -clock aclk [expr 0.4 * $period] [all_outputs]
