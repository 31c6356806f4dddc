// What the stubs of all systems stand on: a bus that plays a script in virtual time, and prints
// what a node sends.
#pragma once

#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>

namespace fake {

struct Message {
  std::int64_t due_us;
  std::uint32_t id;
  std::uint8_t length;
  std::uint8_t data[8];
};
inline constexpr Message script[] = {
    {100'000, 0x609, 8, {0x40, 0x00, 0x20, 0x00, 0, 0, 0, 0}},  // SDO: upload 2000h:00h
    {200'000, 0x000, 2, {0x01, 0x09}},                          // NMT: start node 9
};

inline std::int64_t now_us = 0;
inline unsigned played = 0;
inline unsigned refused = 0;

/// The first frame finds no room, and the second try does.
inline bool transmit(std::uint32_t id, std::uint8_t length, const std::uint8_t* data) {
  if (refused++ == 0) return false;
  std::printf("%03X#", static_cast<unsigned>(id));
  for (unsigned i = 0; i < length; ++i) std::printf("%02X", static_cast<unsigned>(data[i]));
  std::printf("\n");
  return true;
}

/// What has come by now, or nothing.
inline const Message* take() {
  if (played == sizeof(script) / sizeof(*script) || script[played].due_us > now_us) return nullptr;
  return &script[played++];
}

/// Time goes on to the next message, or by as much as the node wants to wait; after 1.5 s all ends.
inline void wait(std::int64_t longest_us) {
  std::int64_t until = now_us + (longest_us > 0 ? longest_us : 1);
  if (played < sizeof(script) / sizeof(*script) && script[played].due_us < until)
    until = script[played].due_us;
  now_us = until > now_us ? until : now_us + 1;
  if (now_us > 1'500'000) {
    std::fflush(stdout);
    std::_Exit(0);
  }
}

}  // namespace fake
