#include "canvoy/web/request_target.hpp"

#include <algorithm>

namespace canvoy::web {

namespace {

constexpr char first_printed = 0x21;
constexpr char last_printed = 0x7E;

/// The value of a hexadecimal digit, or -1.
int digit_value(char c) {
  if (c >= '0' && c <= '9') return c - '0';
  if (c >= 'A' && c <= 'F') return c - 'A' + 10;
  if (c >= 'a' && c <= 'f') return c - 'a' + 10;
  return -1;
}

bool goes_up(std::string_view path) {
  return path == "/.." || path.find("/../") != std::string_view::npos || path.ends_with("/..");
}

/// Takes the text up to the sign, and the sign.
std::string_view take_until(std::string_view& text, char sign) {
  const std::size_t end = std::min(text.find(sign), text.size());
  const std::string_view taken = text.substr(0, end);
  text.remove_prefix(std::min(end + 1, text.size()));
  return taken;
}

bool add_query(RequestTarget& target, std::string_view text) {
  while (!text.empty()) {
    std::string_view pair = take_until(text, '&');
    if (pair.empty()) continue;
    std::optional<std::string> name = percent_decoded(take_until(pair, '='), true);
    std::optional<std::string> value = percent_decoded(pair, true);
    if (!name || !value) return false;
    target.query.emplace_back(*std::move(name), *std::move(value));
  }
  return true;
}

}  // namespace

std::optional<std::string_view> RequestTarget::value(std::string_view name) const {
  const auto found =
      std::ranges::find_if(query, [&](const auto& each) { return each.first == name; });
  if (found == query.end()) return std::nullopt;
  return found->second;
}

std::optional<std::string> percent_decoded(std::string_view text, bool is_form) {
  std::string decoded;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '+' && is_form) {
      decoded += ' ';
    } else if (text[i] != '%') {
      decoded += text[i];
    } else {
      if (text.size() - i < 3) return std::nullopt;
      const int high = digit_value(text[i + 1]);
      const int low = digit_value(text[i + 2]);
      if (high < 0 || low < 0) return std::nullopt;
      decoded += static_cast<char>(high * 16 + low);
      i += 2;
    }
  }
  return decoded;
}

std::optional<RequestTarget> parse_target(std::string_view text) {
  if (text.size() > target_length_max) return std::nullopt;
  constexpr std::string_view scheme = "http://";
  std::string host;
  if (text.starts_with(scheme)) {
    text.remove_prefix(scheme.size());
    host = text.substr(0, text.find_first_of("/?"));
    if (host.empty()) return std::nullopt;
    text.remove_prefix(host.size());
    if (text.empty()) text = "/";
  }
  if (!text.starts_with('/')) return std::nullopt;
  const auto is_printed = [](char c) { return c >= first_printed && c <= last_printed; };
  if (!std::ranges::all_of(text, is_printed)) return std::nullopt;
  std::optional<std::string> path = percent_decoded(take_until(text, '?'), false);
  if (!path || goes_up(*path) || path->find('\0') != std::string::npos) return std::nullopt;
  RequestTarget target{.path = *std::move(path), .host = std::move(host)};
  if (!add_query(target, text)) return std::nullopt;
  return target;
}

}  // namespace canvoy::web
