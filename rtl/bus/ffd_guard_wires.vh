// Wires between the halves of the DMA and ffd_dma_guard (ffd_guard_connections.vh).
// SPDX-License-Identifier: Apache-2.0
wire        ar_valid;
wire        ar_ready;
wire [63:0] ar_address;
wire [7:0]  ar_len;
wire        r_valid;
wire        r_ready;
wire        aw_valid;
wire        aw_ready;
wire [63:0] aw_address;
wire [7:0]  aw_len;
wire        w_valid;
wire        w_ready;
wire [DATA_WIDTH-1:0] w_data;
wire [DATA_WIDTH/8-1:0] w_strobe;
wire        w_last;
wire        b_valid;
wire        b_ready;
wire [63:0] read_first;
wire [63:0] read_last;
wire [63:0] write_first;
wire [63:0] write_last;
