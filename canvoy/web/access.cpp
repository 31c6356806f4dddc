#include "canvoy/web/access.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <random>

namespace canvoy::web {

namespace {

char lower(char c) {
  return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}

/// Compares hosts and origins without case (RFC 3986, 3.2.2).
bool is_same_name(std::string_view one, std::string_view other) {
  return std::ranges::equal(one, other, {}, lower, lower);
}

bool is_own_host(const AccessRules& rules, std::string_view host) {
  const std::array<std::string_view, 4> own = {"localhost", "127.0.0.1", "[::1]", rules.host};
  return std::ranges::any_of(own, [&](std::string_view name) {
    if (name.empty()) return false;
    if (is_same_name(host, fmt::format("{}:{}", name, rules.port))) return true;
    return rules.port == 80 && is_same_name(host, name);
  });
}

/// Takes the same time for each token of this length.
bool is_same_secret(std::string_view given, std::string_view secret) {
  if (given.size() != secret.size()) return false;
  unsigned difference = 0;
  for (std::size_t i = 0; i < given.size(); ++i) {
    difference |= static_cast<unsigned>(static_cast<unsigned char>(given[i]) ^
                                        static_cast<unsigned char>(secret[i]));
  }
  return difference == 0;
}

}  // namespace

std::string_view refusal_of(const AccessRules& rules, const AccessClaims& claims) {
  if (rules.is_loopback && !is_own_host(rules, claims.host)) {
    return "this host is none of this machine's names with this port";
  }
  const bool has_origin = !claims.origin.empty();
  if (has_origin && !is_same_name(claims.origin, fmt::format("http://{}", claims.host))) {
    return "a page of another origin asks";
  }
  const bool is_own_site =
      claims.site.empty() || claims.site == "same-origin" || claims.site == "none";
  if (!is_own_site) return "a page of another site asks";
  if (!is_same_secret(claims.token, rules.token)) {
    return "the token is missing or wrong: open the address that the command has printed";
  }
  return {};
}

std::string_view cookie_of(std::string_view header, std::string_view name) {
  while (!header.empty()) {
    std::string_view each = header.substr(0, header.find(';'));
    header.remove_prefix(std::min(each.size() + 1, header.size()));
    while (each.starts_with(' ')) each.remove_prefix(1);
    if (each.starts_with(name) && each.substr(name.size()).starts_with('=')) {
      return each.substr(name.size() + 1);
    }
  }
  return {};
}

std::string make_token() {
  std::random_device chance;
  std::string token;
  for (int i = 0; i < 4; ++i) token += fmt::format("{:08x}", chance());
  return token;
}

}  // namespace canvoy::web
