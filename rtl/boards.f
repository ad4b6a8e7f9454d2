// The tops of boards and what only they use, relative to this folder, beside hwffd.f.
// Made by tools/tables/generated_files.py from what is there; changes here are lost.
board/ffd_board_bridge.v
board/ffd_board_icebreaker.v
board/ffd_board_reset.v
board/ffd_board_uart_rx.v
board/ffd_board_uart_tx.v
board/ffd_board_ulx3s.v
