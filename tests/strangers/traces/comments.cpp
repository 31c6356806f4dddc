// canvoy_trace_comments FILE: a pcapng with a comment to each packet, for tshark.
#include "canvoy/formats/trace/trace_writer.hpp"

int main(int count, char** arguments) {
  using namespace canvoy;
  using namespace canvoy::formats;
  if (count != 2) return 2;
  host::Result<TraceWriter> writer = TraceWriter::create(arguments[1], TraceFormat::pcapng);
  if (!writer) return 1;
  TraceFrame frame;
  frame.time = Time{} + 1'700'000'000s + 125us;
  frame.channel = "can0";
  frame.frame = Frame::data_frame(0x185, {0x1E, 0x2F});
  if (!writer->write(frame, "node 5: temperature = 20.000 \u00B0C")) return 1;
  frame.frame = Frame::data_frame(0x080, {});
  if (!writer->write(frame)) return 1;
  frame.frame = Frame::data_frame(0x705, {5});
  if (!writer->write(frame, "node 5: operational")) return 1;
  return writer->flush() ? 0 : 1;
}
