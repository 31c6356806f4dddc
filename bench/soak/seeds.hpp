// The command line of a soak: `PROGRAM LAST` or `PROGRAM FIRST LAST`, and a run for each seed.
#pragma once

#include <charconv>
#include <cstdint>
#include <cstdio>
#include <optional>
#include <string_view>

namespace canvoy::soak {

inline std::optional<std::uint64_t> seed_of(std::string_view text) {
  std::uint64_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
  return value;
}

/// `is_good` runs one seed. The exit status: 0 where all are, 1 where one is not, 2 for wrong
/// usage.
inline int run_seeds(const char* program, int count, char** arguments,
                     bool (*is_good)(std::uint64_t)) {
  const std::optional<std::uint64_t> first = count > 2 ? seed_of(arguments[1]) : 1;
  const std::optional<std::uint64_t> last = count > 1 ? seed_of(arguments[count - 1]) : 1000;
  if (!first || !last || count > 3) {
    std::fprintf(stderr, "usage: %s [[FIRST] LAST]: numbers of seeds\n", program);
    return 2;
  }
  unsigned bad = 0;
  for (std::uint64_t seed = *first; seed <= *last; ++seed) bad += is_good(seed) ? 0U : 1U;
  std::printf("%llu seeds, %u with a wrong verdict\n",
              static_cast<unsigned long long>(*last - *first + 1), bad);
  return bad == 0 ? 0 : 1;
}

}  // namespace canvoy::soak
