// SIGINT, SIGTERM and SIGHUP as a request to end, which long operations check between steps in any
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
inline void wish(int /*signal*/) {
  is_wished = true;
}
}  // namespace interruption

/// Makes the signals set only is_interrupted(). An ignored SIGHUP stays ignored: a program started
/// by nohup is to outlive the terminal.
inline void heed_interruption() {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    const auto before = std::signal(signal, interruption::wish);
    if (signal == SIGHUP && before == SIG_IGN) std::signal(SIGHUP, SIG_IGN);
  }
}

/// True if a signal has come since the start of the program.
inline bool is_interrupted() {
  return interruption::is_wished;
}

}  // namespace canvoy::tools
