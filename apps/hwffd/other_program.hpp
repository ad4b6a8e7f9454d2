#pragma once

namespace hwffd::command {

/// Becomes the program hwffd-NAME for the command line `hwffd NAME WORD...`, as git does: the one
/// beside this program, else that on PATH. Returns if the first word is no name of such a program.
/// @throws UsageError if it is one, and the program is not there
void become_other_program(char** argv);

}  // namespace hwffd::command
