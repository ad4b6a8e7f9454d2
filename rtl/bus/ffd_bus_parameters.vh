// Parameters of the core behind its buses, as all that hand them on have them: rtl/top/hwffd_axi.v.
// To be included in a module's parameters.
// SPDX-License-Identifier: Apache-2.0
`include "ffd_row_parameters.vh"
parameter AXIS              = 16,
parameter PAGES             = 2,
parameter IN_FLIGHT         = 0,
parameter WAITING           = 16,
parameter FEATURES          = `FFD_FEATURES,
parameter SPANS             = 1,
parameter MAX_BURST         = 256,
parameter READ_DEPTH        = 512,
parameter WRITE_DEPTH       = 512,
parameter READ_OUTSTANDING  = 8,
parameter WRITE_OUTSTANDING = 8,
parameter FLUSH_CLOCKS      = 16,
parameter COUNT_WIDTH       = 0,
parameter BUS_TIMEOUT       = 1048576,
parameter AXI_PROT          = 2,
parameter AXI_CACHE         = 2,
parameter ADDRESS_WIDTH     = 64,
parameter DATA_WIDTH        = 128,
parameter ID_WIDTH          = 1,
parameter ID                = 0,
parameter HARDENED          = 0
