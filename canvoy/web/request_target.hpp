// What a request asks for: the target of its first line (RFC 9112, 3.2), as a path and what follows
// the question mark.
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
  std::string host{};  ///< of the absolute form, instead of the field Host; empty: another form

  /// The first of this name.
  std::optional<std::string_view> value(std::string_view name) const;
};

inline constexpr std::size_t target_length_max = 4096;

/// In origin form or in absolute form (3.2.1, 3.2.2). Nothing where it is none: no slash in front,
/// a percent sign without two digits behind it, a character that must not be there, too long, or a
/// path that goes up.
std::optional<RequestTarget> parse_target(std::string_view text);

/// `%20` and, where it is a form, `+` as they are meant; nothing where that is wrong.
std::optional<std::string> percent_decoded(std::string_view text, bool is_form);

}  // namespace canvoy::web
