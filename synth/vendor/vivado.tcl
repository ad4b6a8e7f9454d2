# A core by itself through Vivado, out of context; not run by this project's tests, which have no Vivado.
#
#   vivado -mode batch -source synth/vendor/vivado.tcl -tclargs hwffd_stream xc7a100tcsg324-1 ORG=1 FORMAT=18
#
# Reports of area and timing go to build/vivado/. The clock to be reached is in synth/constraints/xilinx7.xdc.
# SPDX-License-Identifier: Apache-2.0
set root [file normalize [file join [file dirname [info script]] .. ..]]
lassign $argv top part
set generics [lrange $argv 2 end]
set folders {}
set sources {}
set list [open [file join $root rtl hwffd.f]]
while {[gets $list line] >= 0} {
  if {[string match "+incdir+*" $line]} {
    lappend folders [file join $root rtl [string range $line 8 end]]
  } elseif {[string match "*.v" $line]} {
    lappend sources [file join $root rtl $line]
  }
}
close $list
read_verilog $sources
read_xdc -mode out_of_context [file join $root synth constraints xilinx7.xdc]
synth_design -mode out_of_context -top $top -part $part -include_dirs $folders -generic $generics
set reports [file join $root build vivado]
file mkdir $reports
report_utilization -file [file join $reports $top.synthesized.txt]
opt_design
place_design
route_design
report_utilization -file [file join $reports $top.utilization.txt]
report_timing_summary -file [file join $reports $top.timing.txt]
