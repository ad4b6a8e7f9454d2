// The parameters of ffd_bus_parameters.vh, handed on under the same names. To be included in an
// instance.
// SPDX-License-Identifier: Apache-2.0
.MAX_BURST        (MAX_BURST),
.READ_DEPTH       (READ_DEPTH),
.WRITE_DEPTH      (WRITE_DEPTH),
.READ_OUTSTANDING (READ_OUTSTANDING),
.WRITE_OUTSTANDING(WRITE_OUTSTANDING),
.FLUSH_CLOCKS     (FLUSH_CLOCKS),
.COUNT_WIDTH      (COUNT_WIDTH),
.BUS_TIMEOUT      (BUS_TIMEOUT),
.AXI_PROT         (AXI_PROT),
.AXI_CACHE        (AXI_CACHE),
.ADDRESS_WIDTH    (ADDRESS_WIDTH),
.DATA_WIDTH       (DATA_WIDTH),
.ID_WIDTH         (ID_WIDTH),
.ID               (ID),
`include "ffd_stream_arguments.vh"
