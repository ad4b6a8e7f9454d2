// Every source of the core, one a line, relative to this folder. Order does not matter.
number/ffd_num_delay.v
