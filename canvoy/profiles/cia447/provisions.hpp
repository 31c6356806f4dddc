// Provisions of CiA 447-3 for the bytes sent to a printer (Table 381).
#pragma once

#include "canvoy/profiles/model/provisions.hpp"

namespace canvoy::cia447 {

inline constexpr std::uint16_t printer_transport_index = 0x60EB;
inline constexpr std::uint16_t printer_mode_status_index = 0x60EA;

/// How the bytes of 60EBh are coded in a mode of 60EAh.
constexpr CodingProvision printed(std::int64_t mode, std::string_view content,
                                  std::string_view coding) {
  return {printer_transport_index, 0, printer_mode_status_index, mode, content, coding,
          "4.2.13.10, Table 381"};
}
inline constexpr CodingProvision printer_codings[] = {
    printed(0, "Text", "UTF-8"),
    printed(1, "Graphics black with ESC", "1 bit a pixel, 1: a dot; the leftmost in the MSB"),
    printed(2, "Graphics gray with ESC", "1 byte a pixel: 00h white (not printed) to FFh black"),
    printed(3, "Graphics RGB with ESC", "3 bytes a pixel, R, G, B: 00h none to FFh full color"),
    printed(4, "Graphics CYMK with ESC", "4 bytes a pixel, C, Y, M, K: 00h none to FFh full color"),
    printed(5, "Logo mode", "1 byte a logo: 20h is logo 1, 33h logo 20"),
};

/// In modes with ESC, a command has two bytes, the first 1Bh; in text and logo modes it has one.
constexpr CommandProvision escaped(std::uint8_t byte, std::string_view command) {
  constexpr std::uint16_t escape = 0x1B00;
  return {printer_transport_index,
          0,
          printer_mode_status_index,
          1,
          4,
          static_cast<std::uint16_t>(escape | byte),
          command,
          "4.2.13.10, Table 381"};
}
/// A command of one byte, in a mode of 60EAh.
constexpr CommandProvision bare(std::int64_t mode, std::uint8_t byte, std::string_view command) {
  return {printer_transport_index, 0, printer_mode_status_index, mode, mode, byte, command,
          "4.2.13.10, Table 381"};
}
inline constexpr std::string_view cut_paper = "cut paper";
inline constexpr std::string_view new_line =
    "new line: of text a line of characters down, of logos 1 pixel";
inline constexpr std::string_view carriage_return = "carriage return";
inline constexpr std::string_view data_1b = "a data byte 1Bh";
inline constexpr CommandProvision printer_commands[] = {
    escaped(0x04, cut_paper),       escaped(0x0A, new_line),        escaped(0x0D, carriage_return),
    escaped(0x1B, data_1b),         bare(0, 0x04, cut_paper),       bare(0, 0x0A, new_line),
    bare(0, 0x0D, carriage_return), bare(0, 0x1B, data_1b),         bare(5, 0x04, cut_paper),
    bare(5, 0x0A, new_line),        bare(5, 0x0D, carriage_return), bare(5, 0x1B, data_1b),
};

inline constexpr Provisions provisions = {.codings = printer_codings, .commands = printer_commands};

}  // namespace canvoy::cia447
