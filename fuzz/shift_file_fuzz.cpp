// Arbitrary text as a recorded shift of an excavator: it is refused, or is written as a file with
// the same meaning.
#include <cstdint>
#include <string_view>

#include "canvoy/tools/cli/failure.hpp"
#include "canvoy/tools/play/shift_file.hpp"
#include "fuzz/require.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace canvoy;
  excavator::RecordedShift shift;
  try {
    shift = tools::parse_shift("shift.csv",
                               std::string_view(reinterpret_cast<const char*>(data), size));
  } catch (const tools::Failure&) {
    return 0;
  }
  Time last{};
  for (const excavator::HandMove& move : shift) {
    fuzz::require(move.at >= last);
    fuzz::require(!excavator::is_place(move.input) || (move.value >= -1 && move.value <= 1));
    last = move.at;
  }
  fuzz::require(tools::parse_shift("shift.csv", tools::shift_text(shift)) == shift);
  return 0;
}
