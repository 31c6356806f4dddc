// Which format a file has shows how it begins.
#include <algorithm>
#include <string_view>

#include "canvoy/formats/trace_parser.hpp"
#include "canvoy/formats/trace_text.hpp"

namespace canvoy::formats {

namespace {

std::unique_ptr<TraceParser> recognize_line(std::string_view line) {
  skip_blanks(line);
  if (line.starts_with('(') || line.starts_with("DROPCOUNT")) return make_candump_parser();
  if (line.starts_with("date ") || line.starts_with("base hex") || line.starts_with("base dec"))
    return make_asc_parser();
  if (line.starts_with(';')) return make_trc_parser();
  return nullptr;
}

std::unique_ptr<TraceParser> recognize_magic(std::string_view head) {
  if (head.starts_with("\x0A\x0D\x0D\x0A")) return make_pcapng_parser();
  if (head.starts_with("\xD4\xC3\xB2\xA1")) return make_pcap_parser(false, false);
  if (head.starts_with("\xA1\xB2\xC3\xD4")) return make_pcap_parser(true, false);
  if (head.starts_with("\x4D\x3C\xB2\xA1")) return make_pcap_parser(false, true);
  if (head.starts_with("\xA1\xB2\x3C\x4D")) return make_pcap_parser(true, true);
  return nullptr;
}

}  // namespace

// An empty file is a log in which nothing happened.
std::unique_ptr<TraceParser> recognize_trace(std::string_view head) {
  if (std::unique_ptr<TraceParser> parser = recognize_magic(head)) return parser;
  if (head.find_first_not_of(" \t\r\n") == std::string_view::npos) return make_candump_parser();
  while (!head.empty()) {
    const std::string_view line = head.substr(0, head.find('\n'));
    if (std::unique_ptr<TraceParser> parser = recognize_line(line)) return parser;
    head.remove_prefix(std::min(line.size() + 1, head.size()));
  }
  return nullptr;
}

}  // namespace canvoy::formats
