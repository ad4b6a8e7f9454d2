# hwffd_stream or hwffd_axi by themselves, for OpenSTA and other tools that read SDC.
# The period in ns: `set period 8.0` before this file is read, else 10.
# SPDX-License-Identifier: Apache-2.0
if {![info exists period]} {
  set period 10.0
}

# One clock for everything.
create_clock -name aclk -period $period [get_ports aclk]

# What surrounds the core may use 40 % of the period before its inputs and behind its outputs.
# aresetn is among the inputs: it is synchronous, so its path counts.
set inputs {}
foreach port [all_inputs] {
  if {[get_property $port full_name] ne "aclk"} {
    lappend inputs $port
  }
}
set_input_delay -clock aclk -min 0.0 $inputs
set_input_delay -clock aclk -max [expr 0.4 * $period] $inputs
set_output_delay -clock aclk -min 0.0 [all_outputs]
set_output_delay -clock aclk -max [expr 0.4 * $period] [all_outputs]

# The interrupt of hwffd_axi goes to a processor that synchronizes it: no path of this clock.
foreach port [all_outputs] {
  if {[get_property $port full_name] eq "irq_o"} {
    set_false_path -to $port
  }
}
