#include "canvoy/tools/device/hand_lines.hpp"

#include <fmt/format.h>
#include <poll.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdio>

#include "canvoy/tools/failure.hpp"

namespace canvoy::tools {

void HandLines::read(const std::function<void(const std::string& order)>& take, Duration now) {
  while (!has_ended_) {
    pollfd input = {.fd = STDIN_FILENO, .events = POLLIN, .revents = 0};
    if (::poll(&input, 1, 0) <= 0) return;
    std::array<char, 4096> bytes;
    const ssize_t size = ::read(STDIN_FILENO, bytes.data(), bytes.size());
    if (size < 0 && (errno == EAGAIN || errno == EINTR)) return;
    has_ended_ = size <= 0;
    for (ssize_t i = 0; i < size; ++i) {
      const char letter = bytes.at(static_cast<std::size_t>(i));
      if (letter == '\n') {
        end_line(take, now);
      } else if (line_.size() <= line_max) {
        line_ += letter;
      }
    }
  }
  if (!line_.empty()) end_line(take, now);
}

void HandLines::end_line(const std::function<void(const std::string& order)>& take, Duration now) {
  ++number_;
  constexpr const char* blanks = " \t\r";
  const std::size_t first = line_.find_first_not_of(blanks);
  const std::size_t last = line_.find_last_not_of(blanks);
  std::string order = first == std::string::npos ? "" : line_.substr(first, last - first + 1);
  line_.clear();
  if (order.empty() || order.starts_with('#')) return;
  const auto refuse = [this](const std::string& what) {
    has_failed_ = true;
    fmt::print(stderr, "canvoy: standard input: line {}: {}\n", number_, what);
  };
  if (order.size() > line_max) return refuse("it is too long");
  if (order.find('@') == std::string::npos) {
    order += fmt::format("@{}us", std::chrono::microseconds(now).count());
  }
  try {
    take(order);
  } catch (const UsageError& error) {
    refuse(error.what());
  }
}

}  // namespace canvoy::tools
