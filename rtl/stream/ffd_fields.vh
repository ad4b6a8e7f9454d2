// Made from rtl/stream/fields.csv by tools/tables/generated_files.py; changes here are lost.
// Fields of the stream's inner words, bit or range of bits.
// SPDX-License-Identifier: Apache-2.0
`ifndef FFD_FIELDS_VH
`define FFD_FIELDS_VH
`define FFD_USER_TAG         15:0  // what came with the vertex; goes out with its result
`define FFD_USER_STATUS      21:16 // the status bits that are known before evaluation
`define FFD_USER_BLANK       22    // the result has no coordinates
`define FFD_USER_LAST        23    // of the last vertex of its packet
`define FFD_USER_HALF        24    // its result is half a beat
`define FFD_USER_BANK        25    // of coefficients that it reads
`define FFD_USER_BUFFER      26    // of the resident lattice that it reads
`define FFD_USER_RESIDENT    27    // its points are those of the resident lattice, else of a slot
`define FFD_STATUS_SATURATED 0     // a coordinate did not fit its word
`define FFD_STATUS_CLAMPED   1     // a coordinate was outside and is clamped
`define FFD_STATUS_NAN       2     // a coordinate is not a number
`define FFD_STATUS_OUTSIDE   3     // the cell is not one of the lattice
`define FFD_STATUS_TRUNCATED 4     // its packet ended too early
`define FFD_STATUS_UNLOADED  5     // coefficients or lattice were never loaded
`define FFD_STATUS_FOLDED    6     // det J is not positive
`define FFD_RETIRE_BANK      0     // its bank of coefficients
`define FFD_RETIRE_BUFFER    1     // its buffer of the resident lattice
`define FFD_RETIRE_RESIDENT  2     // it has read that buffer
`define FFD_PACKET_COEFFICIENTS 0     // opcode 1: functions of every cell
`define FFD_PACKET_LATTICE   1     // opcode 2: a whole lattice
`define FFD_PACKET_VERTICES  2     // opcode 3: vertices of the lattice
`define FFD_PACKET_INTERLEAVED 3     // opcode 4: vertices with points of their own
`define FFD_PACKET_PAGE      4     // opcode 5: a lattice for a page
`define FFD_PACKET_POINTS    5     // opcode 6: points of a page
`define FFD_PACKET_PAGE_VERTICES 6     // opcode 7: vertices of a page
`define FFD_PACKET_GRID      7     // opcode 8: vertices of a grid
`define FFD_PACKET_SPANS     8     // opcode 9: functions of spans
`define FFD_PACKET_GRADIENTS 9     // opcode 10: vertices and their gradients
`define FFD_PACKET_COLLECT   10    // opcode 11: the sums of a page
`define FFD_FRAME_INDEX      11:0  // place in the payload, three digits, the fastest lowest
`define FFD_FRAME_TOP        12    // every digit of it is at its last value
`define FFD_FRAME_HEADER     13    // the header of a packet
`define FFD_FRAME_BANK       14    // of coefficients, which wait for their bank
`define FFD_FRAME_BUFFER     15    // of a lattice, which waits for its buffer
`define FFD_FRAME_FUNCTION   16    // a blending function
`define FFD_FRAME_POINT      17    // a point of the resident lattice
`define FFD_FRAME_VERTEX     18    // a vertex
`define FFD_FRAME_POINTS     19    // four words of an interleaved vertex's points
`define FFD_FRAME_FINISH     20    // a vertex ends with it
`define FFD_FRAME_FINAL      21    // that is the last of its packet
`define FFD_FRAME_UNKNOWN    22    // event: unknown opcode
`define FFD_FRAME_SHORT      23    // event: packet too short
`define FFD_FRAME_LONG       24    // event: packet too long
`define FFD_FRAME_SIZE       25    // event: dimensions of a lattice
`define FFD_FRAME_HIGH       31:26 // bits 5, 4 of each digit of the place, where axes are long
`define FFD_FRAME_PAGE       32    // a header that waits for what is known of its page
`define FFD_FRAME_SPAN       33    // event: spans beyond the table
`define FFD_FRAME_REFUSED    34    // event: a grid or a packed vertex that is refused
`define FFD_FRAME_PACKET     45:35 // of a header: the kind of its packet
`define FFD_FRAME_STOPPED    46    // event: a grid that is stopped, at its last vertex
`define FFD_USER_SATURATED   16    // of user's status
`define FFD_USER_CLAMPED     17    // of user's status
`define FFD_USER_NAN         18    // of user's status
`define FFD_USER_OUTSIDE     19    // of user's status
`define FFD_USER_TRUNCATED   20    // of user's status
`define FFD_USER_UNLOADED    21    // of user's status
`define FFD_USER_W           28    // width
`define FFD_RETIRE_W         3     // width
`define FFD_STATUS_W         7     // width
`define FFD_PACKET_W         11    // width
`define FFD_FRAME_W          47    // width
`endif
