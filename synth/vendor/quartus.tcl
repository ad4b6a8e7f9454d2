# A core by itself through Quartus; not run by this project's tests, which have no Quartus.
#
#   quartus_sh -t synth/vendor/quartus.tcl hwffd_stream 5CEBA9F23C7 ORG=1 FORMAT=18
#
# The project lies in build/quartus/, with its reports. The clock to be reached is in synth/vendor/core.sdc. Ports are
# virtual pins but for the clock, since a core by itself has more of them than a chip.
# SPDX-License-Identifier: Apache-2.0
load_package flow
set root [file normalize [file join [file dirname [info script]] .. ..]]
lassign $quartus(args) top part
set folder [file join $root build quartus]
file mkdir $folder
cd $folder
project_new -overwrite $top
set_global_assignment -name DEVICE $part
set_global_assignment -name TOP_LEVEL_ENTITY $top
set list [open [file join $root rtl hwffd.f]]
while {[gets $list line] >= 0} {
  if {[string match "+incdir+*" $line]} {
    set_global_assignment -name SEARCH_PATH [file join $root rtl [string range $line 8 end]]
  } elseif {[string match "*.v" $line]} {
    set_global_assignment -name VERILOG_FILE [file join $root rtl $line]
  }
}
close $list
set_global_assignment -name SDC_FILE [file join $root synth vendor core.sdc]
foreach generic [lrange $quartus(args) 2 end] {
  lassign [split $generic =] name value
  set_parameter -name $name $value
}
set_instance_assignment -name VIRTUAL_PIN ON -to *
set_instance_assignment -name VIRTUAL_PIN OFF -to aclk
execute_flow -compile
project_close
