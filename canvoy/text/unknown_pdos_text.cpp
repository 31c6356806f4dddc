#include "canvoy/text/unknown_pdos_text.hpp"

#include <fmt/format.h>

#include "canvoy/profiles/registry.hpp"

namespace canvoy::text {

std::string unknown_pdos_text(decoder::UnknownPdos& unknown, const decoder::Network& network,
                              const UnknownPdosWords& words) {
  const decoder::UnknownPdos::Count count = unknown.count(network);
  if (count.frames == 0) return {};
  const bool is_one = words.is_counted && count.frames == 1;
  const std::string number = words.is_counted ? fmt::format("{} ", count.frames) : "";
  const std::string frames =
      fmt::format("{}PDO{} {}", number, is_one ? " is" : "s are", words.fate);
  const std::string of_bus = words.bus.empty() ? "" : fmt::format("{}=", words.bus);
  const std::string why =
      count.is_any_node_known
          ? fmt::format("{}, since not all nodes have told their profile (1000h)", frames)
          : fmt::format("no node has told its profile (1000h): {}", frames);
  if (const Profile* profile = unknown.guess(network)) {
    return fmt::format("{}; {} like {}: --profile {}{}", why, is_one ? "it looks" : "they look",
                       profile->name, of_bus, short_name(*profile));
  }
  if (words.only_with_guess) return {};
  return fmt::format("{}; --profile or --node NODE=PROFILE says which", why);
}

}  // namespace canvoy::text
