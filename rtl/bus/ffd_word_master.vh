// Ports of the bus of the registers to words, each joined with its wire (ffd_word_wires.vh). To be
// included in an instance, as the last of its ports.
// SPDX-License-Identifier: Apache-2.0
.m_awake       (awake),
.m_write_valid (write_valid),
.m_write_word  (write_word),
.m_write_data  (write_data),
.m_write_strobe(write_strobe),
.m_write_error (write_error),
.m_read_valid  (read_valid),
.m_read_word   (read_word),
.m_read_data   (read_data),
.m_read_error  (read_error)
