#include "canvoy/web/request_head.hpp"

#include <algorithm>

namespace canvoy::web {

namespace {

/// Compares without case; `word` is in lower case.
bool is_same(std::string_view text, std::string_view word) {
  const auto lower = [](char c) {
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  };
  return std::ranges::equal(text, word, {}, lower);
}

}  // namespace

std::string_view fault_of(const HeadCounts& counts) {
  if (counts.hosts > 1) return "a request has one Host";
  if (counts.hosts == 0 && counts.is_1_1) return "a request of HTTP/1.1 has a Host";
  if (counts.origins > 1) return "a request has one Origin";
  if (counts.sites > 1) return "a request has one Sec-Fetch-Site";
  if (counts.authorizations > 1) return "a request has one Authorization";
  if (counts.types > 1) return "a request has one Content-Type";
  if (counts.socket_keys > 1) return "a request has one Sec-WebSocket-Key";
  if (!counts.coding.empty() && !is_same(counts.coding, "chunked")) {
    return "a body comes as it is, or chunked";
  }
  return {};
}

bool is_socket_key(std::string_view text) {
  constexpr std::size_t digits = 22;  // 16 bytes, and four zero bits
  constexpr std::string_view last_digits = "AQgw";
  const auto is_digit = [](char c) {
    return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '+' ||
           c == '/';
  };
  return text.size() == digits + 2 && text.ends_with("==") &&
         std::ranges::all_of(text.substr(0, digits), is_digit) &&
         last_digits.find(text[digits - 1]) != std::string_view::npos;
}

bool is_json(std::string_view type) {
  return is_same(type.substr(0, type.find_first_of("; \t")), "application/json");
}

bool accepts_gzip(std::string_view accepted) {
  while (!accepted.empty()) {
    std::string_view each = accepted.substr(0, accepted.find(','));
    accepted.remove_prefix(std::min(each.size() + 1, accepted.size()));
    each.remove_prefix(std::min(each.find_first_not_of(" \t"), each.size()));
    const std::size_t end = std::min(each.find_first_of("; \t"), each.size());
    if (each.substr(0, end) != "gzip") continue;
    const std::size_t weight = each.find("q=");
    return weight == std::string_view::npos ||
           each.find_first_of("123456789", weight) != std::string_view::npos;
  }
  return false;
}

}  // namespace canvoy::web
