// Ports of the words of registers, each joined with the port of the same name. To be included in an
// instance, with more to follow.
// SPDX-License-Identifier: Apache-2.0
.s_clearing              (s_clearing),
.s_write_valid           (s_write_valid),
.s_write_word            (s_write_word),
.s_write_data            (s_write_data),
.s_write_strobe          (s_write_strobe),
.s_write_error           (s_write_error),
.s_read_valid            (s_read_valid),
.s_read_word             (s_read_word),
.s_read_data             (s_read_data),
.s_read_error            (s_read_error),
