// SIGINT and SIGTERM as a wish to end: asked for between two steps of whatever takes long, by any
// thread.
//
//     heed_interruption();
//     while (!is_interrupted()) step();
#pragma once

#include <atomic>
#include <csignal>

namespace canvoy::tools {

namespace interruption {
inline std::atomic<bool> is_wished = false;
static_assert(std::atomic<bool>::is_always_lock_free, "a signal handler may write it");
}  // namespace interruption

/// From now on both signals only set is_interrupted().
inline void heed_interruption() {
  for (const int signal : {SIGINT, SIGTERM}) {
    std::signal(signal, [](int) { interruption::is_wished = true; });
  }
}

/// Since the start of the program.
inline bool is_interrupted() {
  return interruption::is_wished;
}

}  // namespace canvoy::tools
