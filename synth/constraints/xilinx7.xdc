# hwffd_stream or hwffd_axi by themselves, out of context; in a design the clock comes from there.
# SPDX-License-Identifier: Apache-2.0

# The period in ns: the one number to change, as XDC knows no defaults.
set period 10.0

# One clock for everything.
create_clock -name aclk -period $period [get_ports aclk]

# What surrounds the core may use 40 % of the period before its inputs and behind its outputs.
# aresetn is among the inputs: it is synchronous, so its path counts.
set inputs [get_ports -filter {DIRECTION == IN && NAME != aclk}]
set_input_delay -clock aclk -min 0.0 $inputs
set_input_delay -clock aclk -max [expr 0.4 * $period] $inputs
set_output_delay -clock aclk -min 0.0 [all_outputs]
set_output_delay -clock aclk -max [expr 0.4 * $period] [all_outputs]

# The interrupt of hwffd_axi goes to a processor that synchronizes it: no path of this clock.
set_false_path -quiet -to [get_ports -quiet irq_o]
