// Options of programs of others, in lines that begin with the name of the program: `candump -ta
// can0 -n 5`, `canplayer -I a.log`. Letters may be joined, as getopt allows it.
//
//     use_program(words);  // monitor can0 --count 5
#pragma once

#include <string>
#include <vector>

namespace canvoy::tools {

/// Makes our line of the line of another program; others stay as they are. What concerns the looks
/// of its output only is left out. Throws UsageError with the intended line.
void use_program(std::vector<std::string>& words);

/// Leaves out `--interface pcan` and the like, which name a driver of python-can, and takes the bus
/// from `--channel can0`.
void use_python_can_options(std::vector<std::string>& words);

}  // namespace canvoy::tools
