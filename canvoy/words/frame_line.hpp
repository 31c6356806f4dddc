// A frame with what it means as a line for people, millions of them a second; frame_json.hpp is the
// same for programs.
//
//     append_frame_line(lines, {time, "can0", "18A#A00001"}, words, words.text);
//     // (1700000000.000125) can0 18A#A00001  TPDO1  node 10 (0Ah): temperature = 20.000 °C
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "canvoy/can/time.hpp"
#include "canvoy/words/frame_decoder.hpp"

namespace canvoy::words {

struct FrameHead {
  Duration time;         ///< since 1970
  std::string_view bus;  ///< as a terminal can show it
  std::string_view frame;
};

/// Without a break at its end; `text` stands for that of the words.
void append_frame_line(std::string& line, const FrameHead& head, const FrameWords& words,
                       std::string_view text);
/// For terminals of few columns: the time since the first frame, no bus where its name is empty,
/// `10:` for a node. Where it is longer than `width`, it goes on in further lines, indented: all of
/// it is shown.
///
///     12.345 18A#A00001           TPDO1 10: temperature = 20.000 °C
void append_narrow_line(std::string& line, const FrameHead& head, const FrameWords& words,
                        std::string_view text, std::size_t width);
/// Its end: `node 10 (0Ah): temperature = 20.000 °C [!] wrong length`.
void append_meaning(std::string& line, const FrameWords& words, std::string_view text);

}  // namespace canvoy::words
