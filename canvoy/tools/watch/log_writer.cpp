#include "canvoy/tools/watch/log_writer.hpp"

#include <fmt/format.h>

#include <optional>
#include <utility>

#include "canvoy/tools/cli/failure.hpp"

namespace canvoy::tools {

formats::TraceFormat format_to_write(const std::string& path) {
  const std::optional<formats::TraceFormat> format = formats::trace_format_of(path);
  if (format && format->is_written()) return *format;
  throw UsageError(fmt::format("{}: its end says no format; these are written: {}", path,
                               formats::trace_format_list(true)));
}

std::string log_option_text(std::string_view what) {
  return fmt::format("{}: by the end of the name {}, with .gz behind it compressed; else candump's",
                     what, formats::trace_ending_list(true));
}

host::Result<LogWriter> LogWriter::create(const std::string& path, Duration epoch) {
  const std::optional<formats::TraceFormat> format = formats::trace_format_of(path);
  const bool is_plain = !format || !format->is_written() ||
                        (*format == formats::TraceFormat::candump && !formats::names_gzip(path));
  if (is_plain) {
    host::Result<host::CandumpWriter> writer = host::CandumpWriter::create(path, epoch);
    if (!writer) return writer.error();
    return LogWriter(*std::move(writer));
  }
  host::Result<formats::TraceWriter> writer = formats::TraceWriter::create(path, *format);
  if (!writer) return writer.error();
  return LogWriter(Other{*std::move(writer), epoch});
}

host::Result<void> LogWriter::write(Time time, std::string_view bus, const Frame& frame) {
  auto* const other = std::get_if<Other>(&writer_);
  if (other == nullptr) return std::get<host::CandumpWriter>(writer_).write(time, bus, frame);
  return other->writer.write({time + other->epoch, frame, bus});
}

host::Result<void> LogWriter::flush_each_second(Time clock) {
  auto* const other = std::get_if<Other>(&writer_);
  if (other == nullptr) return std::get<host::CandumpWriter>(writer_).flush_each_second(clock);
  if (clock < other->next_flush) return {};
  other->next_flush = clock + Duration(1s);
  return other->writer.flush();
}

host::Result<void> LogWriter::finish() {
  auto* const other = std::get_if<Other>(&writer_);
  return other == nullptr ? std::get<host::CandumpWriter>(writer_).flush() : other->writer.finish();
}

}  // namespace canvoy::tools
