// What a decoder found in a frame, as people read it.
//
//     object_name_text(value);    // "Input group 1, Virtual input 3"
//     marks_text(decoded.marks);  // "reserved, wrong length"
#pragma once

#include <string>

#include "canvoy/decoder/decoder.hpp"

namespace canvoy::words {

/// The name of an object and of its entry, with their numbers; `6000h:01h` where nobody knows it.
std::string object_name_text(const decoder::DecodedValue& value);
/// `reserved, wrong length`; empty where nothing is wrong.
std::string marks_text(decoder::Marks marks);

}  // namespace canvoy::words
