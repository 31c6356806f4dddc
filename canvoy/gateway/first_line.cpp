#include "canvoy/gateway/first_line.hpp"

#include <algorithm>
#include <array>

namespace canvoy::gateway {

namespace {

constexpr char tls_handshake = 0x16;  // the content type of a record (RFC 8446, 5.1)
constexpr std::string_view blanks = " \t\r\n";
constexpr std::array<std::string_view, 9> methods{
    "GET ", "HEAD ", "POST ", "PUT ", "DELETE ", "CONNECT ", "OPTIONS ", "TRACE ", "PATCH "};

bool is_letter(char c) {
  return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z');
}

/// True for a request line: with a known method, or with any other and a version. A first word
/// without an end also counts: commands without a sequence are short.
bool is_http(std::string_view line, bool whole) {
  if (line.empty() || !is_letter(line.front())) return false;
  const auto begins = [line](std::string_view method) { return line.starts_with(method); };
  return !whole || std::ranges::any_of(methods, begins) ||
         line.find(" HTTP/") != std::string_view::npos;
}

}  // namespace

std::string_view FirstLine::append(std::string_view bytes) {
  if (ended_) return {};
  if (text_.empty()) bytes.remove_prefix(std::min(bytes.find_first_not_of(blanks), bytes.size()));
  const std::size_t end = bytes.find('\n');
  text_ += bytes.substr(0, std::min(end, length_max - text_.size()));
  if (text_.starts_with(tls_handshake)) return "TLS";
  const bool whole = end != std::string_view::npos && text_.size() < length_max;
  ended_ = whole || text_.size() == length_max;
  return ended_ && is_http(text_, whole) ? "HTTP" : std::string_view{};
}

}  // namespace canvoy::gateway
