// A device of the catalogue and a foreign SDO client at the other end of its cable, for tests of
// its answers, by frames.
//
//     ForeignClient desk(*find_device_kind("charger"));
//     desk.start();                                     // NMT state operational
//     EXPECT_EQ(desk.write(0x6000, 0, {0x00}), AbortCode::none);
//     EXPECT_EQ(*desk.read(0x6000, 0), ForeignClient::Bytes{0x00});
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <vector>

#include "canvoy/canopen/testing/cable.hpp"
#include "canvoy/devices/testing/every_device.hpp"

namespace canvoy {

/// Expedited for values of 1 to 4 bytes, otherwise segmented with their size.
class ForeignClient {
 public:
  using Bytes = std::vector<std::uint8_t>;

  explicit ForeignClient(const DeviceKind& kind) : device_(cable_.port(0), kind) {
    cable_.connect(0, device_.node());
    cable_.start_all();
    cable_.run_for(1s);
  }
  void start() {
    cable_.send("000#01 00");
    cable_.run_for(1s);
  }
  NodeId id() { return device_.node().id(); }

  Result<Bytes> read(std::uint16_t index, std::uint8_t sub) {
    Frame answer = ask({0x40, low(index), high(index), sub});
    if (answer.data[0] == aborted) return abort_of(answer);
    const unsigned command = answer.data[0];
    if ((command & 2) != 0) {
      const unsigned unused = (command & 1) != 0 ? command >> 2 & 3 : 0;
      return Bytes(answer.data.begin() + 4, answer.data.begin() + 8 - unused);
    }
    Bytes value;
    for (std::uint8_t toggle = 0;; toggle ^= 0x10) {
      answer = ask({static_cast<std::uint8_t>(0x60 | toggle)});
      if (answer.data[0] == aborted) return abort_of(answer);
      const unsigned unused = answer.data[0] >> 1 & 7U;
      value.insert(value.end(), answer.data.begin() + 1, answer.data.begin() + 8 - unused);
      if ((answer.data[0] & 1) != 0) return value;
    }
  }

  AbortCode write(std::uint16_t index, std::uint8_t sub, const Bytes& value) {
    const bool is_short = value.size() >= 1 && value.size() <= 4;
    std::array<std::uint8_t, 8> request{0x21, low(index), high(index), sub};
    store(&request[4], static_cast<std::uint32_t>(value.size()));
    if (is_short) {
      request[0] = static_cast<std::uint8_t>(0x23 | (4 - value.size()) << 2);
      std::ranges::copy(value, request.begin() + 4);
    }
    Frame answer = ask(request);
    if (answer.data[0] == aborted) return abort_of(answer);
    if (is_short) return AbortCode::none;
    std::uint8_t toggle = 0;
    std::size_t sent = 0;
    do {
      const std::size_t now = std::min<std::size_t>(value.size() - sent, 7);
      const bool is_last = sent + now == value.size();
      std::array<std::uint8_t, 8> segment{
          static_cast<std::uint8_t>(toggle | (7 - now) << 1 | (is_last ? 1U : 0U))};
      std::copy_n(value.begin() + static_cast<std::ptrdiff_t>(sent), now, segment.begin() + 1);
      answer = ask(segment);
      if (answer.data[0] == aborted) return abort_of(answer);
      sent += now;
      toggle ^= 0x10;
    } while (sent < value.size());
    return AbortCode::none;
  }

 private:
  static constexpr std::uint8_t aborted = 0x80;
  static std::uint8_t low(std::uint16_t index) { return static_cast<std::uint8_t>(index); }
  static std::uint8_t high(std::uint16_t index) { return static_cast<std::uint8_t>(index >> 8); }
  static AbortCode abort_of(const Frame& answer) {
    return AbortCode{load<std::uint32_t>(answer.data.data() + 4)};
  }

  Frame ask(const std::array<std::uint8_t, 8>& request) {
    Frame frame = Frame::data_frame(0x600U + id(), {});
    frame.length = 8;
    frame.data = request;
    cable_.clear();
    cable_.send(frame);
    const std::uint32_t from_server = 0x580U + id();
    for (int i = 0; i < 100 && cable_.count(from_server) == 0; ++i) cable_.run_for(1ms);
    const Frame* const answer = cable_.last_frame(from_server);
    EXPECT_NE(answer, nullptr) << wire_text(frame);
    return answer == nullptr ? wire_frame("580#80 00 00 00 00 00 00 00") : *answer;
  }

  Cable cable_;
  DeviceOfKind device_;
};

}  // namespace canvoy
