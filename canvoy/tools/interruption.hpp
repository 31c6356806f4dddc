// SIGINT, SIGTERM and SIGHUP as a wish to end: asked for between two steps of whatever takes long,
// by any thread.
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
inline void wish(int /*signal*/) {
  is_wished = true;
}
}  // namespace interruption

/// From now on the signals only set is_interrupted(). SIGHUP that is ignored stays so: who starts a
/// program by nohup wants it to outlive the terminal.
inline void heed_interruption() {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    const auto before = std::signal(signal, interruption::wish);
    if (signal == SIGHUP && before == SIG_IGN) std::signal(SIGHUP, SIG_IGN);
  }
}

/// Since the start of the program.
inline bool is_interrupted() {
  return interruption::is_wished;
}

}  // namespace canvoy::tools
