// A recorded shift of an excavator as a CSV file: a line for each movement of a hand, in order of
// time.
//
//     seconds,input,value
//     0.5,lever,1              # down
//     2,lock,0.12              # a button, and how long it is held, in s
//     2.5,right_y,0.08         # where a stick, pedal or wheel is then: -1 to 1
//     3,knob,-1                # clicks
//     3,operator,digs          # what the person begins to do: tells when service is judged
#pragma once

#include <string>
#include <string_view>

#include "canvoy/worlds/excavator/recorded_shift.hpp"

namespace canvoy::tools {

/// Throws Failure with file and line: the file cannot be read, a line is malformed, a value is out
/// of range, a time is before the last one, there are more than ten million lines.
excavator::RecordedShift read_shift(const std::string& path);
/// Parses the content of a file; `name` is used in errors.
excavator::RecordedShift parse_shift(std::string_view name, std::string_view text);

/// Text that parse_shift() reads as the same shift.
std::string shift_text(const excavator::RecordedShift& shift);
/// Throws Failure if the file cannot be written.
void write_shift(const std::string& path, const excavator::RecordedShift& shift);

}  // namespace canvoy::tools
