// Cost of decoding a frame: its objects, the words with names and units, and the line that `canvoy
// decode` prints, where most values repeat those of the previous frame, or where all change.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <array>
#include <string>

#include "canvoy/can/frame_text.hpp"
#include "canvoy/canopen/protocol/little_endian.hpp"
#include "canvoy/decoder/decoder.hpp"
#include "canvoy/profiles/registry.hpp"
#include "canvoy/text/frame_decoder.hpp"
#include "canvoy/tools/watch/frame_printer.hpp"

namespace canvoy {
namespace {

/// The frames of a charger and its battery in a cycle.
std::array<Frame, 6> cycle() {
  const auto frame = [](std::string_view text) { return parse_frame(text).frame; };
  return {frame("20A#01"),     frame("18A#A00001"), frame("28A#A000018FBE0000"),
          frame("38A#C00314"), frame("70A#05"),     frame("30A#010002")};
}

template <class Decoder>
void decode_cycles(benchmark::State& state) {
  Decoder decoder;
  decoder.network().set_profile(10, *find_profile("418"));
  const auto frames = cycle();
  for (auto _ : state) {
    for (const Frame& frame : frames) benchmark::DoNotOptimize(decoder.decode(frame));
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(frames.size()));
}
void print_cycles(benchmark::State& state, bool changing, bool json) {
  tools::FramePrinter printer({.nodes = {"10=418"}, .json = json});
  auto frames = cycle();
  std::string lines;
  std::uint16_t count = 0;
  for (auto _ : state) {
    lines.clear();
    for (Frame& frame : frames) {
      if (changing && frame.length > 1) store(frame.data.data(), ++count);
      printer.append(lines, Duration{1'700'000'000'000'125}, "can0", frame);
    }
    benchmark::DoNotOptimize(lines.data());
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(frames.size()));
}
/// Dialogue of a tool and a device: reads, a write, a text in segments, an abort.
constexpr std::array<std::string_view, 12> sdo_dialogue = {
    "60A#4010600000000000", "58A#4B106000A0000000", "60A#2B17100032000000", "58A#6017100000000000",
    "60A#4008100000000000", "58A#410810000A000000", "60A#6000000000000000", "58A#0043616E766F7920",
    "60A#7000000000000000", "58A#1942434400000000", "60A#4018100500000000", "58A#8018100511000906"};

void print_sdo(benchmark::State& state) {
  tools::FramePrinter printer({.nodes = {"10=418"}});
  std::array<Frame, sdo_dialogue.size()> frames;
  std::ranges::transform(sdo_dialogue, frames.begin(),
                         [](std::string_view text) { return parse_frame(text).frame; });
  std::string lines;
  for (auto _ : state) {
    lines.clear();
    for (const Frame& frame : frames) {
      printer.append(lines, Duration{1'700'000'000'000'125}, "can0", frame);
    }
    benchmark::DoNotOptimize(lines.data());
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(frames.size()));
}
BENCHMARK(print_sdo)->Name("decode/lines of SDO");
BENCHMARK_CAPTURE(print_cycles, same, false, false)->Name("decode/lines");
BENCHMARK_CAPTURE(print_cycles, changing, true, false)->Name("decode/lines of changing values");
BENCHMARK_CAPTURE(print_cycles, same_json, false, true)->Name("decode/JSON");
BENCHMARK_CAPTURE(print_cycles, changing_json, true, true)->Name("decode/JSON of changing values");
BENCHMARK(decode_cycles<decoder::Decoder>)->Name("decode/objects");
BENCHMARK(decode_cycles<text::FrameDecoder>)->Name("decode/words");

}  // namespace
}  // namespace canvoy
