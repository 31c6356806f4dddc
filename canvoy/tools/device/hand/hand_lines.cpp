#include "canvoy/tools/device/hand/hand_lines.hpp"

#include <fmt/format.h>
#include <poll.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdio>

#include "canvoy/formats/plain_text.hpp"
#include "canvoy/tools/cli/failure.hpp"
#include "canvoy/tools/terminal/message.hpp"

namespace canvoy::tools {

namespace {

/// True if it ends with a time: `hire@2s`, `@1.5min`.
bool has_time(std::string_view order) {
  const std::size_t at = order.rfind('@');
  if (at == std::string_view::npos || at + 1 == order.size()) return false;
  const std::string_view time = order.substr(at + 1);
  return std::ranges::all_of(time, [](char each) {
    return (each >= '0' && each <= '9') || (each >= 'a' && each <= 'z') || each == '.';
  });
}

}  // namespace

std::vector<std::string> separate_orders(const std::vector<std::string>& said) {
  std::vector<std::string> orders;
  for (const std::string& text : said) {
    std::size_t begin = 0;
    for (std::size_t i = 0; i < text.size(); ++i) {
      if (text[i] != ',' || !has_time(std::string_view(text).substr(begin, i - begin))) continue;
      orders.push_back(text.substr(begin, i - begin));
      begin = i + 1;
    }
    orders.push_back(text.substr(begin));
  }
  return orders;
}

void HandLines::read(const std::function<void(const std::string& order)>& take, Duration now) {
  while (!has_ended_) {
    pollfd input = {.fd = STDIN_FILENO, .events = POLLIN, .revents = 0};
    if (::poll(&input, 1, 0) <= 0) return;
    std::array<char, 4096> bytes;
    const ssize_t size = ::read(STDIN_FILENO, bytes.data(), bytes.size());
    if (size < 0 && (errno == EAGAIN || errno == EINTR)) return;
    has_ended_ = size <= 0;
    reader_.append(has_ended_ ? "\n"
                              : std::string_view(bytes.data(), static_cast<std::size_t>(size)));
    while (const auto line = reader_.next()) take_line(*line, take, now);
  }
}

void HandLines::take_line(const gateway::Line& line,
                          const std::function<void(const std::string& order)>& take, Duration now) {
  ++number_;
  std::string order(formats::trimmed(line.text));
  if (order.empty() || order.starts_with('#')) return;
  const auto refuse = [this](const std::string& what) {
    has_failed_ = true;
    print_message(fmt::format("canvoy: standard input: line {}: {}", number_, what));
  };
  if (line.too_long) return refuse("it is too long");
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
