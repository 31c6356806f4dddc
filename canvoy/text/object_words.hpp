// Text of what a decoder found in a frame.
//
//     object_name_text(value);    // "Input group 1, Virtual input 3"
//     marks_text(decoded.marks);  // "reserved, wrong length"
#pragma once

#include <string>

#include "canvoy/decoder/decoder.hpp"

namespace canvoy::text {

/// The names of an object and its entry, with their numbers; `6000h:01h` if unknown.
std::string object_name_text(const decoder::DecodedValue& value);
/// `reserved, wrong length`; empty without marks.
std::string marks_text(decoder::Marks marks);

}  // namespace canvoy::text
