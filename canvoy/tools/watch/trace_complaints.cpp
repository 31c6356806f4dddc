#include "canvoy/tools/watch/trace_complaints.hpp"

#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include "canvoy/tools/cli/failure.hpp"
#include "canvoy/tools/terminal/message.hpp"

namespace canvoy::tools {

void show_bad(const std::string& log, const LogReader& trace) {
  if (trace.bad() > bad_shown_max) return;
  print_message(fmt::format("{}, {}: {}", log, trace.where(), trace.problem()));
}

void show_shifted(const std::string& out, const formats::TraceWriter& writer) {
  const auto show = [&out](std::uint64_t count, std::string_view how) {
    if (count == 0) return;
    print_message(fmt::format("{}: {} frame{} {}, and got the time of that; a .log keeps all times",
                              out, count, count == 1 ? " was" : "s were", how));
  };
  show(writer.early(), "earlier than its beginning");
  show(writer.late(), "later than what its format can say at most");
}

std::string format_in_words(const LogReader& trace) {
  constexpr std::string_view vowels = "AEIOUaeiou";
  const std::string name(trace.format().name);
  return (vowels.find(name.front()) == std::string_view::npos ? "a " : "an ") + name;
}

void refuse_log_without_frames(const std::string& log, const LogReader& trace) {
  if (trace.frames() > 0) return;
  if (trace.position() == 0) throw Failure(log + ": it is empty");
  if (trace.fd_frames() > 0) {
    throw Failure(fmt::format("{}: all {} frames in it are of CAN FD, which CANopen does not use",
                              log, trace.fd_frames()));
  }
  throw Failure(fmt::format("{}: no frame can be read in it, though it looks like {}", log,
                            format_in_words(trace)));
}

bool is_log_itself(const std::string& log, const std::string& out) {
  struct stat read {};
  struct stat written {};
  const bool is_there =
      (log == "-" ? ::fstat(STDIN_FILENO, &read) : ::stat(log.c_str(), &read)) == 0 &&
      ::stat(out.c_str(), &written) == 0;
  return is_there && read.st_dev == written.st_dev && read.st_ino == written.st_ino;
}

}  // namespace canvoy::tools
