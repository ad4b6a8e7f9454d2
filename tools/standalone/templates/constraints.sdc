# {{ core.prefix }} by itself, out of context; in a design the clock comes from there. {{ kind }}
# Made by {{ core.command }}
# SPDX-License-Identifier: Apache-2.0

# The period in ns: the one number to change.
set period 10.0

# One clock for everything.
create_clock -name aclk -period $period [get_ports aclk]

# What surrounds the core may use 40 % of the period before its inputs and behind its outputs. aresetn is
# among the inputs: it is synchronous, so its path counts.
set inputs [get_ports { {{ inputs | join(" ") }} }]
set outputs [get_ports { {{ outputs | join(" ") }} }]
set_input_delay -clock aclk -min 0.0 $inputs
set_input_delay -clock aclk -max [expr 0.4 * $period] $inputs
set_output_delay -clock aclk -min 0.0 $outputs
set_output_delay -clock aclk -max [expr 0.4 * $period] $outputs
{% if interrupt %}

# The interrupt goes to a processor that synchronizes it: no path of this clock.
set_false_path -to [get_ports irq_o]
{% endif %}
