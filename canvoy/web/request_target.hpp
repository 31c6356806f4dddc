// The target in the first line of a request, as a path and a query (RFC 9112, 3.2).
//
//     std::optional<RequestTarget> target = parse_target("/api/objects?bus=sim0&search=speed");
//     target->path;            // "/api/objects"
//     target->value("search")  // "speed"
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace canvoy::web {

struct RequestTarget {
  std::string path;  ///< begins with a slash
  std::vector<std::pair<std::string, std::string>> query{};
  std::string host{};  ///< from the absolute form, in place of the field Host; empty: another form

  /// The first value with this name.
  std::optional<std::string_view> value(std::string_view name) const;
};

inline constexpr std::size_t target_length_max = 4096;

/// Parses origin form or absolute form (RFC 9112, 3.2.1, 3.2.2). Nothing if it is invalid: no
/// leading slash, a percent sign without two digits, a forbidden character, too long, or a path
/// that goes up.
std::optional<RequestTarget> parse_target(std::string_view text);

/// Decodes `%20` and, for a form, `+`; nothing if invalid.
std::optional<std::string> percent_decoded(std::string_view text, bool is_form);

}  // namespace canvoy::web
