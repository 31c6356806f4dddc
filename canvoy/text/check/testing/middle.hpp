// A device with one defect: a party on the line to the device that changes, drops and adds frames.
//
//     CheckedDevice device(kind);
//     Middle middle(device);
//     apply(device, middle, way);
#pragma once

#include <functional>
#include <initializer_list>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "canvoy/canopen/protocol/little_endian.hpp"
#include "canvoy/text/check/testing/checked_device.hpp"

namespace canvoy::conformance {

/// The party on the line, and its state.
class Middle {
 public:
  explicit Middle(NodeOnLine& device) : device_(device) {}

  std::uint32_t answers() const { return can_id::sdo_response + device_.node(); }
  std::uint32_t requests() const { return can_id::sdo_request + device_.node(); }
  std::uint32_t states() const { return can_id::error_control + device_.node(); }
  std::uint32_t emergencies() const { return can_id::emergency + device_.node(); }
  NodeId node() const { return device_.node(); }
  NmtState state() const { return device_.device().state(); }
  bool is_selected() const { return is_selected_; }  ///< by LSS
  /// Takes a passing frame of either direction.
  void notice(const Frame& frame) {
    if (frame.id == requests()) last_request = frame;
    if (frame.id == can_id::lss_request) last_lss_request = frame;
    if (frame.id == can_id::lss_request && frame.data[0] == 0x04) is_selected_ = false;
    if (frame.id == can_id::lss_response && frame.data[0] == 0x44) is_selected_ = true;
  }
  void add(std::uint32_t id, std::initializer_list<std::uint8_t> bytes) {
    device_.add(Frame::data_frame(id, bytes));
  }

  void add_later(Duration delay, std::uint32_t id, std::initializer_list<std::uint8_t> bytes) {
    device_.add_later(delay, Frame::data_frame(id, bytes));
  }
  /// Delivers a frame to the device, as if another node had sent it.
  void tell_device(const Frame& frame) { device_.deliver(frame); }
  void cancel_later() { device_.cancel_later(); }
  void repeat(const Frame& frame) { device_.add(frame); }
  /// The present value of an entry of the device; 0: it has none.
  std::uint64_t value(std::uint16_t index, std::uint8_t sub = 0) const {
    Dictionary& dictionary = device_.device().dictionary();
    return dictionary.find(index, sub) ? dictionary.number(index, sub) : 0;
  }

  unsigned count = 0;
  Frame last_request{};      ///< sent to the device by SDO
  Frame last_lss_request{};  ///< sent to the device by LSS

 private:
  NodeOnLine& device_;
  bool is_selected_ = false;
};

inline std::uint16_t index_of(const Frame& frame) {
  return load<std::uint16_t>(&frame.data[1]);
}
inline bool is_upload(const Middle& middle, const Frame& frame, std::uint16_t index) {
  return frame.id == middle.answers() && (frame.data[0] & 0xE0) == 0x40 && index_of(frame) == index;
}
inline bool is_download(const Middle& middle, const Frame& frame, std::uint16_t index) {
  return frame.id == middle.requests() && (frame.data[0] & 0xE0) == 0x20 &&
         index_of(frame) == index;
}
inline bool is_abort(const Frame& frame, std::uint16_t index, AbortCode code) {
  return frame.data[0] == 0x80 && index_of(frame) == index &&
         load<std::uint32_t>(&frame.data[4]) == static_cast<std::uint32_t>(code);
}
inline void change_code(Frame& frame, AbortCode code) {
  store(&frame.data[4], static_cast<std::uint32_t>(code));
}
/// Turns a refusal of a write into a confirmation.
inline void say_written(Frame& frame) {
  frame.data[0] = 0x60;
  store(&frame.data[4], std::uint32_t{0});
}

struct Way {
  std::string_view name;
  std::vector<std::string_view> found_by;
  /// Filters frames from the device; false: the frame is lost. Either filter may be empty.
  std::function<bool(Middle&, Frame&)> from_device = {};
  std::function<bool(Middle&, Frame&)> to_device = {};
};

/// A defect of what the device sends; `change` is Way::from_device.
inline Way from_device(std::string_view name, std::vector<std::string_view> found_by,
                       std::function<bool(Middle&, Frame&)> change) {
  return {name, std::move(found_by), std::move(change), {}};
}
/// A defect of what the device receives; `change` is Way::to_device.
inline Way to_device(std::string_view name, std::vector<std::string_view> found_by,
                     std::function<bool(Middle&, Frame&)> change) {
  return {name, std::move(found_by), {}, std::move(change)};
}

/// Identifiers of the failed cases.
inline std::vector<std::string> failures(const Report& report) {
  std::vector<std::string> ids;
  for (const TestResult& each : report.results) {
    if (each.verdict.outcome == Outcome::failed) ids.push_back(each.test->id);
  }
  return ids;
}

inline void apply(NodeOnLine& device, Middle& middle, const Way& way) {
  device.from_device = [&](Frame& frame) {
    middle.notice(frame);
    return !way.from_device || way.from_device(middle, frame);
  };
  device.to_device = [&](Frame& frame) {
    middle.notice(frame);
    return !way.to_device || way.to_device(middle, frame);
  };
}

}  // namespace canvoy::conformance
