// Each behaviour case with a device that does other than its last expectation says: it is found by
// that case. The devices are those of the catalogue; a party on the line, or the person at the
// device, makes the difference. broken_behaviour_test.cpp and broken_transport_test.cpp have
// defects that are tried with all cases, so that no other case may find them.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>

#include "canvoy/canopen/dictionary/object_index.hpp"
#include "canvoy/text/check/behaviour/behaviour_cases.hpp"
#include "canvoy/text/check/testing/all_ways.hpp"
#include "canvoy/text/check/testing/broken_device.hpp"

namespace canvoy::conformance::behaviour_sweep_test {
namespace {

/// What becomes of a bit that counts.
enum class Twist : std::uint8_t { flip, clear, set };

/// What the device does other than expected: as a step that is not met.
struct Lie {
  Act act = Act::none;
  std::uint16_t index = 0;
  std::uint8_t sub = 0;
  std::uint64_t mask = ~0ULL;
  std::string_view words = {};
  Twist twist = Twist::flip;
  std::uint16_t error_code = 0;  ///< of an emergency
};

bool is_expectation(Act act) {
  return act == Act::refuse || act == Act::refuse_text || act == Act::is_text || act == Act::is ||
         act == Act::stays || act == Act::tells || act == Act::is_silent || act == Act::alarm ||
         act == Act::no_alarm || act == Act::see;
}

Lie lie_of(const Step& step) {
  Lie lie{.act = step.act, .mask = step.mask, .words = step.words};
  if (step.act == Act::no_alarm) lie.error_code = static_cast<std::uint16_t>(step.number);
  if (step.place.object != nullptr) {
    lie.index = step.place.index();
    lie.sub = step.place.sub;
  }
  return lie;
}

/// About the last expectation of a row; without one, about its last download.
Lie lie_of(const BehaviourRow& row) {
  Lie lie;
  for (const Step& step : row.steps) {
    const bool is_download = step.act == Act::put || step.act == Act::put_text;
    if (is_expectation(step.act) || (is_download && !is_expectation(lie.act))) lie = lie_of(step);
  }
  return lie;
}

/// Cases that are code, and rows that the opposite of each value passes: what their last
/// expectation is about.
constexpr std::pair<std::string_view, Lie> lies_of_code[] = {
    {"407-event-01", {Act::is, 0x6001, 2, 0x01}},
    {"407-event-02", {.act = Act::tells}},
    {"407-event-03", {Act::is, 0x6001, 1, 0x01}},
    {"407-event-04", {Act::is, 0x6001, 2, 0x01}},
    {"407-event-05", {Act::is, 0x6001, 2, 0x01}},
    {"407-event-06", {Act::is, 0x6001, 2, 0x01}},
    {"401-voltage-07", {.act = Act::is, .index = 0x6422, .sub = 1, .mask = 1, .twist = Twist::set}},
    {"407-counting-01", {Act::is, 0x6721, 2, 0x02}},
    {"407-counting-02", {Act::is, 0x6722, 0, 0x01}},
    {"407-counting-03", {.act = Act::tells}},
    {"419-battery-01", {Act::is, 0x6010, 0}},
    {"419-battery-02", {Act::is, 0x6010, 0}},
    {"419-battery-03", {Act::is, 0x6010, 0}},
    {"419-battery-04", {Act::is, 0x6060, 0}},
    {"419-battery-05", {Act::is, 0x6060, 0}},
    {"419-battery-06", {Act::is, 0x6070, 0}},
    {"419-battery-07", {Act::is, 0x6070, 0}},
    {"419-battery-08", {Act::is, 0x6081, 0}},
    {"419-battery-09", {Act::is, 0x6081, 0}},
    {"419-battery-11", {Act::is, 0x6000, 0}},
    {"419-battery-12", {.act = Act::is, .index = 0x6000, .mask = 1, .twist = Twist::clear}},
    {"419-status-02", {Act::is, 0x6001, 0, 0x80}},
    {"419-loss-04", {Act::is, 0x6001, 0}},
    {"419-charge-07", {Act::is, 0x6080, 0, 0x80}},
    {"417-4-button-01", {.act = Act::tells}},
    {"417-4-button-02", {Act::is, 0x6100, 1, 0x0300'0000'0000}},
    {"417-4-button-03", {Act::is_silent, 0x6010, 0}},
    {"417-4-button-04", {.act = Act::tells}},
    {"417-4-button-05", {.act = Act::tells}},
    {"417-4-button-06", {Act::is_silent, 0x6010, 0}},
    {"417-4-button-07", {Act::refuse, 0x6100, 1}},
    {"417-4-lamp-01", {.act = Act::see, .words = "lamp 1 of the panel is lit"}},
    {"417-4-lamp-02", {Act::is, 0x6200, 1, 0x0100'0000'0000}},
    {"417-4-lamp-03", {Act::stays, 0x6200, 1, 0x0100'0000'0000}},
    {"417-4-lamp-04", {Act::stays, 0x6200, 1, 0x0100'0000'0000}},
    {"417-4-lamp-05", {Act::stays, 0x6200, 1, 0x0100'0000'0000}},
    {"417-4-lamp-06", {.act = Act::see, .words = "lamp 1 of the panel is dark"}},
    {"417-4-lamp-07", {.act = Act::see, .words = "lamp 1 of the panel is dark"}},
};

/// The rows of all tables.
std::vector<BehaviourRow> all_rows() {
  std::vector<BehaviourRow> all;
  const auto add = [&all](std::span<const BehaviourRow> rows) {
    all.insert(all.end(), rows.begin(), rows.end());
  };
  for (const auto rows : {rows_of_401_outputs(), rows_of_401_inputs(), rows_of_852()}) add(rows);
  for (auto&& tables : {rows_of_407(), rows_of_407_passengers(), rows_of_417(),
                        rows_of_417_controllers(), rows_of_447(), rows_of_447_travel()}) {
    for (const auto rows : tables) add(rows);
  }
  return all;
}

std::map<std::string, Lie> all_lies() {
  std::map<std::string, Lie> lies;
  for (const auto& [id, lie] : lies_of_code) lies.emplace(id, lie);
  for (const BehaviourRow& row : all_rows()) lies.emplace(row.id, lie_of(row));
  return lies;
}

/// The party on the line that tells a lie.
class Liar {
 public:
  Liar(CheckedDevice& device, const Lie& lie) : device_(device), middle_(device), lie_(lie) {
    device.from_device = [this](Frame& frame) { return from_device(frame); };
    device.to_device = [this](Frame& frame) { return to_device(frame); };
  }

  /// Sends what must not come: after an action of a person.
  void interfere() {
    if (lie_.act == Act::no_alarm) {
      Frame alarm = Frame::data_frame(middle_.emergencies(), {0, 0, 1, 0, 0, 0, 0, 0});
      store(alarm.data.data(), lie_.error_code);
      device_.add_later(10ms, alarm);
    }
    if (lie_.act != Act::is_silent) return;
    if (const auto id = tpdo_of_place()) device_.add_later(10ms, Frame::data_frame(*id, {0}));
  }

 private:
  bool is_about_place(const Frame& frame) const {
    return index_of(frame) == lie_.index && frame.data[3] == lie_.sub;
  }
  bool from_device(Frame& frame) {
    if (lie_.act == Act::alarm) return frame.id != middle_.emergencies();
    if (lie_.act == Act::tells) return !is_tpdo(frame);
    if (frame.id != middle_.answers()) return true;
    if (frame.data[0] == 0x80) {
      confirm(frame);
    } else if (lie_.act == Act::is || lie_.act == Act::stays || lie_.act == Act::is_text) {
      change_value(frame);
    } else if ((lie_.act == Act::put || lie_.act == Act::put_text) && frame.data[0] == 0x60 &&
               is_about_place(frame)) {
      frame.data[0] = 0x80;
      change_code(frame, AbortCode::general);
    }
    return true;
  }
  bool to_device(Frame& frame) {
    middle_.notice(frame);
    if (frame.id == middle_.requests() && (frame.data[0] & 0xE0) != 0 &&
        (frame.data[0] & 0xE0) != 0x60) {
      is_in_place_ = is_about_place(frame);
    }
    interfere();
    return true;
  }
  /// A refused download is told as done.
  void confirm(Frame& frame) const {
    if ((lie_.act != Act::refuse && lie_.act != Act::refuse_text) || !is_in_place_) return;
    const unsigned command = middle_.last_request.data[0];
    const bool is_segment = (command & 0xE0) == 0;
    const bool is_download = is_segment || (command & 0xE0) == 0x20;
    if (!is_download) return;
    frame.data[0] = static_cast<std::uint8_t>(is_segment ? 0x20 | (command & 0x10) : 0x60);
  }
  /// One bit of the value that counts is another, or always the same.
  void change_value(Frame& frame) const {
    if (!is_in_place_) return;
    unsigned bit = 0;
    while (bit < 63 && (lie_.mask >> bit & 1) == 0) ++bit;
    const unsigned byte = bit / 8;
    const auto flip = static_cast<std::uint8_t>(1U << bit % 8);
    const bool is_initiate = (frame.data[0] & 0xE0) == 0x40;
    if (is_initiate && (frame.data[0] & 2) != 0 && byte < 4) twist(frame.data[4 + byte], flip);
    if ((frame.data[0] & 0xE0) == 0 && byte < 7) twist(frame.data[1 + byte], flip);
  }
  void twist(std::uint8_t& byte, std::uint8_t bit) const {
    if (lie_.twist != Twist::flip) byte |= bit;
    if (lie_.twist != Twist::set) byte ^= bit;
  }
  bool is_tpdo(const Frame& frame) const {
    const bool is_default = frame.id > 0x180 && frame.id < 0x580;
    const bool is_own = frame.id >= 0x6B0 && frame.id <= 0x6BF;
    return frame.is_plain() && (is_default || is_own || frame.id == 0x180);
  }
  /// The CAN-ID of the valid TPDO that carries the place.
  std::optional<std::uint32_t> tpdo_of_place() const {
    const std::uint32_t wanted = std::uint32_t{lie_.index} << 8 | lie_.sub;
    for (unsigned number = 0; number < 0x200; ++number) {
      const auto parameter = static_cast<std::uint16_t>(object_index::tpdo_parameter + number);
      const auto mapping = static_cast<std::uint16_t>(object_index::tpdo_mapping + number);
      const std::uint64_t count = middle_.value(mapping, 0);
      for (std::uint8_t sub = 1; sub <= count && count <= 64; ++sub) {
        if (middle_.value(mapping, sub) >> 8 != wanted) continue;
        const CobId id{static_cast<std::uint32_t>(middle_.value(parameter, 1))};
        if (id.valid()) return id.raw & Frame::id_max;
      }
    }
    return std::nullopt;
  }

  CheckedDevice& device_;
  Middle middle_;
  Lie lie_;
  bool is_in_place_ = false;  ///< the SDO transfer is about the place
};

Outcome try_lie(const DeviceKind& kind, const std::string& id, const Lie& lie) {
  Workshop workshop;
  CheckedDevice device(kind, workshop.environment);
  workshop.drive.connect(device.device());
  Liar liar(device, lie);
  const auto hand = [&, answer = workshop.hands.answer()](const HandRequest& request) {
    if (request.is_question && lie.act == Act::see && request.words == lie.words) {
      return HandAnswer::no;
    }
    const HandAnswer done = answer(request);
    liar.interfere();
    return done;
  };
  Check check(device.line(), device.node(), {.moves = true, .profile = kind.profile, .hand = hand});
  const Report report = check.run({}, id);
  return report.results.size() == 1 ? report.results.front().verdict.outcome
                                    : Outcome::not_applicable;
}

/// Of each behaviour case, a device of the catalogue that passes it.
std::map<std::string, const DeviceKind*> passing_devices() {
  std::map<std::string, const DeviceKind*> passing;
  for (const DeviceKind* kind : every_device_kind()) {
    Workshop workshop;
    CheckedDevice device(*kind, workshop.environment);
    workshop.drive.connect(device.device());
    Check check(device.line(), device.node(),
                {.moves = true, .profile = kind->profile, .hand = workshop.hands.answer()});
    for (const TestResult& each : check.run({}, "behaviour").results) {
      if (each.verdict.outcome == Outcome::passed) passing.try_emplace(each.test->id, kind);
    }
  }
  return passing;
}

TEST(BehaviourSweep, EachCaseFindsADeviceThatDoesOtherwise) {
  const std::map<std::string, const DeviceKind*> passing = passing_devices();
  const std::map<std::string, Lie> lies = all_lies();
  EXPECT_GE(lies.size(), 250U);
  for (const auto& [id, lie] : lies) {
    const auto kind = passing.find(id);
    ASSERT_NE(kind, passing.end()) << id;
    EXPECT_EQ(try_lie(*kind->second, id, lie), Outcome::failed) << id;
  }
}

}  // namespace
}  // namespace canvoy::conformance::behaviour_sweep_test

namespace canvoy::conformance {

std::vector<std::string> lied_cases() {
  std::vector<std::string> ids;
  for (const auto& [id, lie] : behaviour_sweep_test::all_lies()) ids.push_back(id);
  return ids;
}

}  // namespace canvoy::conformance
