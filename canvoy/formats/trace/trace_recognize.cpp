#include "canvoy/formats/trace/trace_recognize.hpp"

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

#include "canvoy/formats/trace/trace_asc.hpp"
#include "canvoy/formats/trace/trace_blf.hpp"
#include "canvoy/formats/trace/trace_candump.hpp"
#include "canvoy/formats/trace/trace_candump_screen.hpp"
#include "canvoy/formats/trace/trace_csv.hpp"
#include "canvoy/formats/trace/trace_pcap.hpp"
#include "canvoy/formats/trace/trace_pcapng.hpp"
#include "canvoy/formats/trace/trace_text.hpp"
#include "canvoy/formats/trace/trace_trc.hpp"

namespace canvoy::formats {

namespace {

std::unique_ptr<TraceParser> recognize_line(std::string_view line, std::string_view rest) {
  ScreenLine screen;
  skip_blanks(line);
  if (line.starts_with('(') || line.starts_with("DROPCOUNT") || screen.parse(line)) {
    return make_candump_parser(ScreenTimes::look_like_deltas(rest));
  }
  if (line.starts_with("date ") || line.starts_with("base hex") || line.starts_with("base dec"))
    return make_asc_parser();
  if (line.starts_with(';')) return make_trc_parser();
  return make_csv_parser(line);
}

std::unique_ptr<TraceParser> recognize_magic(std::string_view head) {
  if (head.starts_with("\x0A\x0D\x0D\x0A")) return make_pcapng_parser();
  if (head.starts_with("\xD4\xC3\xB2\xA1")) return make_pcap_parser(false, false);
  if (head.starts_with("\xA1\xB2\xC3\xD4")) return make_pcap_parser(true, false);
  if (head.starts_with("\x4D\x3C\xB2\xA1")) return make_pcap_parser(false, true);
  if (head.starts_with("\xA1\xB2\x3C\x4D")) return make_pcap_parser(true, true);
  if (head.starts_with("LOGG")) return make_blf_parser();
  return nullptr;
}

}  // namespace

// An empty file is a log in which nothing happened.
std::unique_ptr<TraceParser> recognize_trace(std::string_view head) {
  if (std::unique_ptr<TraceParser> parser = recognize_magic(head)) return parser;
  if (head.find_first_not_of(" \t\r\n") == std::string_view::npos) return make_candump_parser();
  while (!head.empty()) {
    const std::string_view line = head.substr(0, head.find('\n'));
    if (std::unique_ptr<TraceParser> parser = recognize_line(line, head)) return parser;
    head.remove_prefix(std::min(line.size() + 1, head.size()));
  }
  return nullptr;
}

std::string_view looks_like(std::string_view head) {
  using Known = std::pair<std::string_view, std::string_view>;
  constexpr std::array known = {Known{"\xFF\xD8\xFF", "a JPEG picture"},
                                Known{"\x89PNG", "a PNG picture"},
                                Known{"GIF8", "a GIF picture"},
                                Known{"%PDF", "a PDF document"},
                                Known{"\x7F"
                                      "ELF",
                                      "an ELF program"},
                                Known{"MZ", "a Windows program"},
                                Known{"PK\x03\x04", "a zip archive"},
                                Known{"BZh", "a file that bzip2 has compressed"},
                                Known{"\xFD"
                                      "7zXZ",
                                      "a file that xz has compressed"},
                                Known{"\x28\xB5\x2F\xFD", "a file that zstd has compressed"},
                                Known{"SQLite format 3", "an SQLite database"},
                                Known{"MDF ", "an ASAM MDF file"}};
  for (const auto& [magic, name] : known) {
    if (head.starts_with(magic)) return name;
  }
  const bool is_binary = std::ranges::any_of(head, [](char c) {
    return static_cast<unsigned char>(c) < ' ' && c != '\t' && c != '\n' && c != '\r' && c != '\f';
  });
  if (is_binary) return "binary data";
  head.remove_prefix(std::min(head.find_first_not_of(" \t\r\n"), head.size()));
  if (head.starts_with('{') || head.starts_with("[{") || head.starts_with("[\n")) return "JSON";
  if (head.starts_with("<?xml") || head.starts_with('<')) return "XML or HTML";
  if (head.starts_with('[')) return "a data sheet or settings (INI)";
  return "text without frames";
}

}  // namespace canvoy::formats
