#include "canvoy/tools/run/http_request.hpp"

#include <algorithm>
#include <cctype>
#include <optional>
#include <utility>

namespace canvoy::tools {

namespace {

/// A character of a method or of the name of a header (RFC 9110, 5.6.2).
bool is_token_character(char c) {
  constexpr std::string_view marks = "!#$%&'*+-.^_`|~";
  const auto code = static_cast<unsigned char>(c);
  return code < 0x80 && (std::isalnum(code) != 0 || marks.find(c) != marks.npos);
}

bool is_token(std::string_view text) {
  return !text.empty() && std::ranges::all_of(text, is_token_character);
}

/// Visible characters of ASCII.
bool is_target(std::string_view text) {
  return !text.empty() && std::ranges::all_of(text, [](char c) { return c > ' ' && c < '\x7F'; });
}

bool is_header_value(std::string_view text) {
  return std::ranges::all_of(text, [](char c) {
    const auto code = static_cast<unsigned char>(c);
    return code == '\t' || (code >= ' ' && code != 0x7F);
  });
}

/// Takes a line and its end off the front: CR LF, or LF alone (RFC 9112, 2.2).
std::string_view take_line(std::string_view& text) {
  const std::size_t end = text.find('\n');
  std::string_view line = text.substr(0, end);
  text.remove_prefix(end == text.npos ? text.size() : end + 1);
  if (line.ends_with('\r')) line.remove_suffix(1);
  return line;
}

struct RequestLine {
  std::string_view method;
  std::string_view version;  ///< behind `HTTP/`: `1.1`
};

std::optional<RequestLine> request_line(std::string_view line) {
  const std::size_t first = line.find(' ');
  const std::size_t last = line.rfind(' ');
  if (first == line.npos || first == last) return std::nullopt;
  const std::string_view method = line.substr(0, first);
  std::string_view version = line.substr(last + 1);
  constexpr std::string_view protocol = "HTTP/";
  if (!is_token(method) || !is_target(line.substr(first + 1, last - first - 1))) return {};
  if (!version.starts_with(protocol)) return std::nullopt;
  version.remove_prefix(protocol.size());
  const auto is_digit = [](char c) { return c >= '0' && c <= '9'; };
  if (version.size() != 3 || !is_digit(version[0]) || version[1] != '.' || !is_digit(version[2])) {
    return std::nullopt;
  }
  return RequestLine{method, version};
}

bool is_host(std::string_view name) {
  return std::ranges::equal(name, std::string_view("host"), {},
                            [](unsigned char c) { return std::tolower(c); });
}

/// How many headers tell the host; nothing where one is none.
std::optional<std::size_t> count_hosts(std::string_view headers) {
  std::size_t hosts = 0;
  while (!headers.empty()) {
    const std::string_view line = take_line(headers);
    const std::size_t colon = line.find(':');
    if (colon == line.npos || !is_token(line.substr(0, colon))) return std::nullopt;
    if (!is_header_value(line.substr(colon + 1))) return std::nullopt;
    if (is_host(line.substr(0, colon))) ++hosts;
  }
  return hosts;
}

}  // namespace

std::string_view reason_of(HttpStatus status) {
  switch (status) {
    case HttpStatus::ok:
      return "OK";
    case HttpStatus::bad_request:
      return "Bad Request";
    case HttpStatus::method_not_allowed:
      return "Method Not Allowed";
    case HttpStatus::request_time_out:
      return "Request Timeout";
    case HttpStatus::too_large:
      return "Request Header Fields Too Large";
    case HttpStatus::version_not_supported:
      return "HTTP Version Not Supported";
  }
  return "";
}

bool HttpRequest::know(HttpStatus status) {
  status_ = status;
  return is_known_ = true;
}

bool HttpRequest::append(std::string_view bytes) {
  for (const char c : bytes) {
    if (is_known_) break;
    // An empty line before a request is passed over.
    if (head_.empty() && (c == '\r' || c == '\n')) continue;
    if (head_.empty() && !is_token_character(c)) return know(HttpStatus::bad_request);
    if (head_.size() == bytes_max) return know(HttpStatus::too_large);
    head_ += c;
    if (head_.ends_with("\n\n") || head_.ends_with("\n\r\n")) know(judge());
  }
  return is_known_;
}

HttpStatus HttpRequest::judge() {
  std::string_view rest = head_;
  const std::optional<RequestLine> line = request_line(take_line(rest));
  if (!line) return HttpStatus::bad_request;
  is_head_ = line->method == "HEAD";
  if (line->version[0] != '1') return HttpStatus::version_not_supported;
  rest.remove_suffix(rest.ends_with("\r\n") ? 2 : 1);  // the empty line
  const std::optional<std::size_t> hosts = count_hosts(rest);
  // RFC 9112, 3.2.
  const bool may_lack_host = line->version == "1.0";
  if (!hosts || *hosts > 1 || (*hosts == 0 && !may_lack_host)) return HttpStatus::bad_request;
  return is_head_ || line->method == "GET" ? HttpStatus::ok : HttpStatus::method_not_allowed;
}

}  // namespace canvoy::tools
