// Frames per second that are read from a log file and counted (the file is in the page cache).
#include <benchmark/benchmark.h>
#include <unistd.h>

#include <cstdint>
#include <cstdio>
#include <string>

#include "canvoy/formats/trace/trace_writer.hpp"

namespace canvoy::formats {
namespace {

constexpr std::size_t frame_count = 1'000'000;

// A log of a network with PDOs, heartbeats and SYNC: identifiers and lengths change from frame to
// frame.
std::string write_log(TraceFormat format) {
  const std::string path = "/tmp/canvoy_trace_bench_" + std::to_string(::getpid());
  host::Result<TraceWriter> writer = TraceWriter::create(path, format);
  TraceFrame frame;
  frame.channel = "can0";
  for (std::uint32_t number = 0; number < frame_count; ++number) {
    frame.time = Time{} + 1'700'000'000s + number * 125us;
    frame.frame = Frame::data_frame(0x180 + number % 0x400, {1, 2, 3, 4, 5, 6, 7, 8});
    frame.frame.length = static_cast<std::uint8_t>(number % 9);
    for (std::size_t at = frame.frame.length; at < Frame::length_max; ++at)
      frame.frame.data[at] = 0;
    static_cast<void>(writer->write(frame));
  }
  static_cast<void>(writer->flush());
  return path;
}

// Like the programs of PEAK, in the newest version; the library writes no such log.
std::string write_trc() {
  const std::string path = "/tmp/canvoy_trace_bench_" + std::to_string(::getpid());
  std::FILE* file = std::fopen(path.c_str(), "w");
  std::fputs(";$FILEVERSION=2.1\n;$STARTTIME=43008.5\n;$COLUMNS=N,O,T,B,I,d,R,L,D\n", file);
  for (unsigned number = 0; number < frame_count; ++number) {
    std::fprintf(file, "%7u %13.3f DT 1      %04X Rx -  %u   ", number + 1, number * 0.125,
                 0x180 + number % 0x400, number % 9);
    for (unsigned byte = 1; byte <= number % 9; ++byte) std::fprintf(file, " %02X", byte);
    std::fputs(" \n", file);
  }
  std::fclose(file);
  return path;
}

void count_frames(benchmark::State& state, TraceFormat format) {
  const std::string path = format == TraceFormat::trc ? write_trc() : write_log(format);
  std::uint64_t frames = 0;
  for (auto _ : state) {
    host::Result<TraceReader> reader = TraceReader::open(path);
    TraceFrame frame;
    while (reader->next(frame) != TraceRead::end) benchmark::DoNotOptimize(frame);
    frames += reader->frames();
    if (reader->bad() != 0) state.SkipWithError("bad lines");
  }
  std::remove(path.c_str());
  state.SetItemsProcessed(static_cast<std::int64_t>(frames));
}
BENCHMARK_CAPTURE(count_frames, candump, TraceFormat::candump)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(count_frames, asc, TraceFormat::asc)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(count_frames, trc, TraceFormat::trc)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(count_frames, pcapng, TraceFormat::pcapng)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace canvoy::formats
