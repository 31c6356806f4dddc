// Small memcpy and memset, as used where size matters: those of newlib are unrolled, and take 308
// bytes. These are counted.
#include <cstddef>
#include <cstdint>

extern "C" {
[[gnu::optimize("no-tree-loop-distribute-patterns")]] void* memcpy(void* to, const void* from,
                                                                   std::size_t size) {
  while (size-- != 0) {
    static_cast<std::uint8_t*>(to)[size] = static_cast<const std::uint8_t*>(from)[size];
  }
  return to;
}
[[gnu::optimize("no-tree-loop-distribute-patterns")]] void* memset(void* to, int byte,
                                                                   std::size_t size) {
  while (size-- != 0) static_cast<std::uint8_t*>(to)[size] = static_cast<std::uint8_t>(byte);
  return to;
}
}
