#include "canvoy/decoder/mark.hpp"

namespace canvoy::decoder {

std::string_view mark_name(Mark mark) {
  switch (mark) {
    case Mark::reserved:
      return "reserved";
    case Mark::out_of_range:
      return "out of range";
    case Mark::wrong_length:
      return "wrong length";
    case Mark::wrong_access:
      return "wrong access";
    case Mark::wrong_toggle:
      return "wrong toggle bit";
    case Mark::unknown_command:
      return "unknown command";
    case Mark::out_of_place:
      return "out of place";
    case Mark::wrong_checksum:
      break;
  }
  return "wrong checksum";
}

}  // namespace canvoy::decoder
