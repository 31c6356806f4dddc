// Writes a frame with its meaning as a line of text, at a rate of millions per second.
// frame_json.hpp writes JSON.
//
//     append_frame_line(lines, {time, "can0", "18A#A00001"}, words, words.text);
//     // (1700000000.000125) can0 18A#A00001  TPDO1  node 10 (0Ah): temperature = 20.000 °C
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "canvoy/can/time.hpp"
#include "canvoy/text/frame_decoder.hpp"

namespace canvoy::text {

/// Start of a line.
struct FrameHead {
  Duration time;           ///< since 1970
  std::string_view bus;    ///< safe for a terminal
  std::string_view frame;  ///< in the notation of can-utils
};

/// Appends a line without a line end; `text` replaces that of the words.
void append_frame_line(std::string& line, const FrameHead& head, const FrameWords& words,
                       std::string_view text);
/// Like append_frame_line(), but for narrow terminals: the time since the first frame, no bus if
/// its name is empty, and `10:` for a node. Text longer than `width` continues on indented lines;
/// nothing is cut off.
///
/// `12.345 18A#A00001           TPDO1 10: temperature = 20.000 °C`
void append_narrow_line(std::string& line, const FrameHead& head, const FrameWords& words,
                        std::string_view text, std::size_t width);
/// Appends the end of a line: `node 10 (0Ah): temperature = 20.000 °C [!] wrong length`.
void append_meaning(std::string& line, const FrameWords& words, std::string_view text);

}  // namespace canvoy::text
