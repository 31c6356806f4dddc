// Devices that break one rule of CiA 301 each, beyond those of broken_devices_test.cpp: all classes
// that need a device with all services. Each is found by the cases that are about it, and by no
// other.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "canvoy/canopen/protocol/little_endian.hpp"
#include "canvoy/text/check/testing/all_ways.hpp"
#include "canvoy/text/check/testing/communication_device.hpp"

namespace canvoy::conformance::broken_communication_test {
namespace {

using Cases = std::vector<std::string_view>;
using AboutFrame = bool (*)(const Middle&, const Frame&);

/// The device says that it has written what it has refused.
Way takes(std::string_view name, Cases found_by, std::uint16_t index, AboutFrame is_it) {
  return {name, std::move(found_by), [index, is_it](Middle& middle, Frame& frame) {
            const bool is_refused = frame.id == middle.answers() && frame.data[0] == 0x80 &&
                                    index_of(frame) == index && is_it(middle, frame);
            if (is_refused) say_written(frame);
            return true;
          }};
}
/// An answer of the device that is changed.
template <class Change>
Way answers(std::string_view name, Cases found_by, Change change) {
  return {name, std::move(found_by), [change](Middle& middle, Frame& frame) {
            if (frame.id == middle.answers()) change(middle, frame);
            return true;
          }};
}

bool always(const Middle& /*middle*/, const Frame& /*frame*/) {
  return true;
}
template <std::uint8_t sub>
bool is_sub(const Middle& /*middle*/, const Frame& frame) {
  return frame.data[3] == sub;
}
/// True if the device was asked to write these four bytes.
bool was_asked(const Middle& middle, std::uint32_t number) {
  return load<std::uint32_t>(&middle.last_request.data[4]) == number;
}
template <std::uint8_t sub, std::uint32_t number>
bool is_written(const Middle& middle, const Frame& frame) {
  return frame.data[3] == sub && was_asked(middle, number);
}
void abort_with(Frame& frame, AbortCode code) {
  frame.data[0] = 0x80;
  change_code(frame, code);
}
bool is_code(const Frame& frame, AbortCode code) {
  return frame.data[0] == 0x80 &&
         load<std::uint32_t>(&frame.data[4]) == static_cast<std::uint32_t>(code);
}
bool is_asked_by(const Middle& middle, unsigned command) {
  return middle.last_request.data[0] == command;
}

std::vector<Way> sdo_ways() {
  return {
      answers("1000h has three bytes",
              {"sdo-01", "dictionary-01", "dictionary-06", "dictionary-07"},
              [](Middle&, Frame& frame) {
                if (frame.data[0] == 0x43 && index_of(frame) == 0x1000) frame.data[0] = 0x47;
              }),
      answers("an entry of a record is another one", {"sdo-03", "dictionary-01"},
              [](Middle&, Frame& frame) {
                if (frame.data[0] == 0x43 && index_of(frame) == 0x1018 && frame.data[3] == 1) {
                  frame.data[3] = 2;
                }
              }),
      answers("a segment without a transfer is general trouble", {"sdo-12", "sdo-23"},
              [](Middle& middle, Frame& frame) {
                const bool is_it = is_asked_by(middle, 0x60);
                if (is_it && is_code(frame, AbortCode::command_specifier)) {
                  change_code(frame, AbortCode::general);
                }
              }),
      answers("a segment to write without a transfer is general trouble", {"sdo-13", "sdo-21"},
              [](Middle& middle, Frame& frame) {
                const bool is_it = is_asked_by(middle, 0x00) || is_asked_by(middle, 0x0B);
                if (is_it && is_code(frame, AbortCode::command_specifier)) {
                  change_code(frame, AbortCode::general);
                }
              }),
      to_device("1 is written as 2", {"sdo-15"},
                [](Middle& middle, Frame& frame) {
                  const bool is_it = is_download(middle, frame, 0x1017) && frame.data[0] == 0x2B;
                  if (is_it && frame.data[4] == 1 && frame.data[5] == 0) frame.data[4] = 2;
                  return true;
                }),
      answers("a value without its size is refused", {"sdo-16"},
              [](Middle& middle, Frame& frame) {
                if (is_asked_by(middle, 0x22)) abort_with(frame, AbortCode::general);
              }),
      takes("four bytes are taken for two", {"sdo-17"}, 0x1017,
            [](const Middle& middle, const Frame&) { return is_asked_by(middle, 0x23); }),
      takes("one byte is taken for two", {"sdo-18"}, 0x1017,
            [](const Middle& middle, const Frame&) { return is_asked_by(middle, 0x2F); }),
      answers("a segment is confirmed with another toggle bit", {"sdo-19"},
              [](Middle& middle, Frame& frame) {
                if (is_asked_by(middle, 0x0B) && frame.data[0] == 0x20) frame.data[0] = 0x30;
              }),
      answers("a segment to write with a wrong toggle bit is taken", {"sdo-20"},
              [](Middle& middle, Frame& frame) {
                if (is_asked_by(middle, 0x1B) && frame.data[0] == 0x80) frame.data[0] = 0x30;
              }),
      answers("a segment to read with a wrong toggle bit is given", {"sdo-22"},
              [](Middle& middle, Frame& frame) {
                if (is_asked_by(middle, 0x70) && frame.data[0] == 0x80) frame.data[0] = 0x10;
              }),
      answers("the checksum of a block is wrong", {"sdo-25"},
              [](Middle&, Frame& frame) {
                if ((frame.data[0] & 0xE3) == 0xC1) frame.data[1] ^= 1U;
              }),
      answers("a block of no segments is general trouble", {"sdo-26"},
              [](Middle& middle, Frame& frame) {
                const bool is_it = is_asked_by(middle, 0xA0) && frame.data[0] == 0x80;
                if (is_it) change_code(frame, AbortCode::general);
              }),
      answers("the end of a block that is written is not confirmed", {"sdo-27"},
              [](Middle& middle, Frame& frame) {
                const bool is_it = (middle.last_request.data[0] & 0xE3) == 0xC1;
                if (is_it && frame.data[0] == 0xA1) frame.data[0] = 0xA2;
              }),
      answers("a wrong checksum is taken", {"sdo-28"},
              [](Middle& middle, Frame& frame) {
                const bool is_it = (middle.last_request.data[0] & 0xE3) == 0xC1;
                if (is_it && frame.data[0] == 0x80) frame.data[0] = 0xA1;
              }),
  };
}

std::vector<Way> dictionary_ways() {
  return {
      answers("1008h cannot be accessed", {"dictionary-03"},
              [](Middle&, Frame& frame) {
                if (frame.data[0] == 0x41 && index_of(frame) == 0x1008) {
                  abort_with(frame, AbortCode::unsupported_access);
                }
              }),
      answers("what is write only is read", {"dictionary-04"},
              [](Middle&, Frame& frame) {
                if (is_abort(frame, 0x2000, AbortCode::write_only)) frame.data[0] = 0x4F;
              }),
      answers("1015h is read only", {"dictionary-08"},
              [](Middle&, Frame& frame) {
                if (frame.data[0] == 0x60 && index_of(frame) == 0x1015) {
                  abort_with(frame, AbortCode::read_only);
                }
              }),
      takes("2001h takes what is beyond its limits", {"dictionary-09"}, 0x2001, always),
      answers("a sheet's object is more than it says", {"dictionary-11"},
              [](Middle&, Frame& frame) {
                if (is_abort(frame, 0x1002, AbortCode::no_object)) frame.data[0] = 0x43;
              }),
  };
}

std::vector<Way> guarding_ways() {
  const auto is_guarded = [](const Middle& middle, const Frame& frame) {
    return frame.id == middle.states() && frame.length == 1 && frame.data[0] != 0 &&
           !frame.is_remote() && middle.value(0x1017) == 0;
  };
  const auto asks = [](const Middle& middle, const Frame& frame) {
    return frame.id == middle.states() && frame.is_remote();
  };
  // Behind the answer to what was heard.
  const auto alarm = [](Middle& middle) {
    middle.add_later(10ms, middle.emergencies(), {0x30, 0x81, 0x11, 0, 0, 0, 0, 0});
  };
  return {
      from_device("the toggle bit stands still", {"guarding-01"},
                  [is_guarded](Middle& middle, Frame& frame) {
                    if (is_guarded(middle, frame)) frame.data[0] &= 0x7F;
                    return true;
                  }),
      from_device("answers say pre-operational in operational", {"guarding-02"},
                  [is_guarded](Middle& middle, Frame& frame) {
                    const bool is_it = is_guarded(middle, frame) && (frame.data[0] & 0x7F) == 5;
                    if (is_it)
                      frame.data[0] = static_cast<std::uint8_t>((frame.data[0] & 0x80) | 0x7F);
                    return true;
                  }),
      from_device("the toggle bit begins with 1", {"guarding-03"},
                  [is_guarded](Middle& middle, Frame& frame) {
                    if (is_guarded(middle, frame)) frame.data[0] ^= 0x80;
                    return true;
                  }),
      from_device("the end of its life is not told", {"guarding-04"},
                  [](Middle& middle, Frame& frame) {
                    return frame.id != middle.emergencies() || middle.value(0x100D) == 0;
                  }),
      to_device("a life that goes on is an emergency", {"guarding-05"},
                [asks, alarm](Middle& middle, Frame& frame) {
                  if (asks(middle, frame) && middle.value(0x100D) != 0) alarm(middle);
                  return true;
                }),
      to_device("no life is an emergency", {"guarding-06"},
                [asks, alarm](Middle& middle, Frame& frame) {
                  const bool is_it = asks(middle, frame) && middle.value(0x1017) == 0;
                  if (is_it && middle.value(0x100D) == 0) alarm(middle);
                  return true;
                }),
      to_device("it is guarded beside heartbeats", {"both-01"},
                [asks](Middle& middle, Frame& frame) {
                  const bool is_it = asks(middle, frame) && middle.value(0x1017) != 0;
                  if (is_it) middle.add(middle.states(), {0x7F});
                  return true;
                }),
      to_device("it is not guarded again behind heartbeats", {"both-02"},
                [asks](Middle& middle, Frame& frame) {
                  if (is_download(middle, frame, 0x1017)) {
                    const unsigned ms = load<std::uint16_t>(&frame.data[4]);
                    middle.count = ms == 1000 ? 1 : ms == 0 && middle.count == 1 ? 2 : 0;
                  }
                  return !asks(middle, frame) || middle.count != 2;
                }),
      to_device(
          "supervision begins without a heartbeat", {"heartbeat-06"},
          [](Middle& middle, Frame& frame) {
            const bool is_it = is_download(middle, frame, 0x1016) && frame.data[4] == 100;
            const bool is_beat = frame.id == can_id::error_control + node_id_max;
            if (is_it || is_beat) middle.cancel_later();
            if (is_it) {
              middle.add_later(300ms, middle.emergencies(), {0x30, 0x81, 0x11, 0, 0, 0, 0, 0});
            }
            return true;
          }),
      to_device("heartbeats in time are an emergency", {"heartbeat-07"},
                [alarm](Middle& middle, Frame& frame) {
                  const bool is_beat = frame.id == can_id::error_control + node_id_max;
                  if (is_beat && (middle.value(0x1016, 1) & 0xFFFF) == 200) alarm(middle);
                  return true;
                }),
      takes("a node is watched twice", {"heartbeat-08"}, 0x1016, is_sub<2>),
  };
}

std::vector<Way> state_ways() {
  return {
      from_device("pre-operational is told as operational",
                  {"nmt-01", "nmt-07", "nmt-08", "nmt-09", "heartbeat-04", "guarding-02"},
                  [](Middle& middle, Frame& frame) {
                    const bool is_it =
                        frame.id == middle.states() && (frame.data[0] & 0x7F) == 0x7F;
                    if (is_it)
                      frame.data[0] = static_cast<std::uint8_t>((frame.data[0] & 0x80) | 5);
                    return true;
                  }),
      answers("1014h is a CAN-ID of error control",
              {"emergency-01", "heartbeat-05", "guarding-04", "rpdo-12"},
              [](Middle& middle, Frame& frame) {
                if (!is_upload(middle, frame, 0x1014)) return;
                frame.data[4] = 0x01;
                frame.data[5] = 0x07;
              }),
      to_device("1003h keeps what is cleared", {"emergency-05"},
                [](Middle& middle, Frame& frame) {
                  if (!is_download(middle, frame, 0x1003) || frame.data[4] != 0) return true;
                  middle.add(middle.answers(), {0x60, 0x03, 0x10, 0, 0, 0, 0, 0});
                  return false;
                }),
      to_device("an emergency comes though 1014h is invalid", {"emergency-07"},
                [](Middle& middle, Frame& frame) {
                  if (is_download(middle, frame, 0x1014)) frame.data[7] &= 0x7F;
                  return true;
                }),
      answers("1010h:01h has a reserved bit", {"store-01"},
              [](Middle& middle, Frame& frame) {
                if (is_upload(middle, frame, 0x1010) && frame.data[3] == 1) frame.data[4] |= 0x10U;
              }),
      takes("it stores without the signature", {"store-02"}, 0x1010, is_written<1, 0x7361'7665>),
      takes("it restores without the signature", {"store-03"}, 0x1011, is_written<1, 0x7361'7665>),
      takes("1005h takes what is restricted", {"can-id-01"}, 0x1005,
            [](const Middle& middle, const Frame&) { return !was_asked(middle, 0x4000'06BA); }),
      takes("1012h takes what is restricted", {"can-id-02"}, 0x1012, always),
      takes("an RPDO takes what is restricted", {"can-id-04"}, 0x1400,
            [](const Middle& middle, const Frame& frame) {
              return frame.data[3] == 1 && !was_asked(middle, 0x6B9);
            }),
      takes("a TPDO takes what is restricted", {"can-id-05"}, 0x1800,
            [](const Middle& middle, const Frame& frame) {
              return frame.data[3] == 1 && !was_asked(middle, 0x6B8);
            }),
      takes("a further SDO server takes what is restricted", {"can-id-06"}, 0x1201, is_sub<1>),
      takes("an SDO client takes what is restricted", {"can-id-07"}, 0x1280, is_sub<1>),
  };
}

Way not_silent(std::string_view name, Cases found_by, std::uint16_t index, std::uint8_t sub) {
  return {name, std::move(found_by), [index, sub](Middle& middle, Frame& frame) {
            return frame.id != middle.answers() || frame.data[0] != 0x80 ||
                   index_of(frame) != index || frame.data[3] != sub;
          }};
}

/// The ways of a PDO in one direction; `is` is `rpdo` or `tpdo`.
std::vector<Way> rpdo_ways() {
  return {
      answers("an RPDO has seven entries", {"rpdo-01", "dictionary-07", "dictionary-10"},
              [](Middle& middle, Frame& frame) {
                if (is_upload(middle, frame, 0x1400) && frame.data[3] == 0) frame.data[4] = 7;
              }),
      answers("an RPDO is never invalid", {"rpdo-02"},
              [](Middle& middle, Frame& frame) {
                if (is_upload(middle, frame, 0x1400) && frame.data[3] == 1) frame.data[7] &= 0x7F;
              }),
      takes("the CAN-ID of a valid RPDO changes", {"rpdo-03"}, 0x1400, is_written<1, 0x6B9>),
      takes("an RPDO takes a reserved type", {"rpdo-04"}, 0x1400, is_sub<2>),
      answers("sub-index 04h of an RPDO cannot be accessed", {"rpdo-05"},
              [](Middle&, Frame& frame) {
                const bool is_it = is_abort(frame, 0x1400, AbortCode::no_sub_index);
                if (is_it && frame.data[3] == 4) change_code(frame, AbortCode::unsupported_access);
              }),
      answers("an RPDO is not mapped again", {"rpdo-07"},
              [](Middle& middle, Frame& frame) {
                const bool is_it = frame.data[0] == 0x60 && index_of(frame) == 0x1600 &&
                                   frame.data[3] == 2 && was_asked(middle, 0x6200'0208);
                if (is_it) abort_with(frame, AbortCode::general);
              }),
      takes("the mapping of a valid RPDO changes", {"rpdo-08"}, 0x1600, is_written<0, 0>),
      takes("an RPDO maps what is not there", {"rpdo-09"}, 0x1600, is_written<1, 0x0FFF'0020>),
      takes("an RPDO maps the device type", {"rpdo-10"}, 0x1600, is_written<1, 0x1000'0020>),
      takes(
          "an RPDO maps nine bytes", {"rpdo-11"}, 0x1600,
          [](const Middle&, const Frame& frame) { return is_code(frame, AbortCode::pdo_length); }),
      not_silent("a change of the CAN-ID of an RPDO is not answered", {"rpdo-03", "can-id-04"},
                 0x1400, 1),
      not_silent("a reserved type of an RPDO is not answered", {"rpdo-04"}, 0x1400, 2),
  };
}

std::vector<Way> tpdo_ways() {
  return {
      answers("a TPDO has seven entries", {"tpdo-01", "dictionary-07", "dictionary-10"},
              [](Middle& middle, Frame& frame) {
                if (is_upload(middle, frame, 0x1800) && frame.data[3] == 0) frame.data[4] = 7;
              }),
      answers("a TPDO is never invalid", {"tpdo-02"},
              [](Middle& middle, Frame& frame) {
                if (is_upload(middle, frame, 0x1800) && frame.data[3] == 1) frame.data[7] &= 0x7F;
              }),
      takes("the CAN-ID of a valid TPDO changes", {"tpdo-03"}, 0x1800, is_written<1, 0x6B8>),
      answers("sub-index 04h of a TPDO is there", {"tpdo-05"},
              [](Middle&, Frame& frame) {
                const bool is_it = is_abort(frame, 0x1800, AbortCode::no_sub_index);
                if (is_it && frame.data[3] == 4) frame.data[0] = 0x4F;
              }),
      takes("the inhibit time of a valid TPDO changes", {"tpdo-06"}, 0x1800, is_sub<3>),
      answers("a TPDO is not mapped again", {"tpdo-07"},
              [](Middle& middle, Frame& frame) {
                const bool is_it = frame.data[0] == 0x60 && index_of(frame) == 0x1A00 &&
                                   frame.data[3] == 2 && was_asked(middle, 0x6000'0208);
                if (is_it) abort_with(frame, AbortCode::general);
              }),
      takes("the mapping of a valid TPDO changes", {"tpdo-08"}, 0x1A00, is_written<0, 0>),
      takes("a TPDO maps what is not there", {"tpdo-09"}, 0x1A00, is_written<1, 0x0FFF'0020>),
      takes("a TPDO maps the device type", {"tpdo-10"}, 0x1A00, is_written<1, 0x1000'0020>),
      takes(
          "a TPDO maps nine bytes", {"tpdo-11"}, 0x1A00,
          [](const Middle&, const Frame& frame) { return is_code(frame, AbortCode::pdo_length); }),
      to_device("an invalid TPDO follows SYNC", {"tpdo-16"},
                [](Middle& middle, Frame& frame) {
                  const bool is_invalid = (middle.value(0x1800, 1) & CobId::bit31) != 0;
                  const bool runs = middle.state() == NmtState::operational;
                  if (frame.id == can_id::sync && is_invalid && runs) middle.add(0x6B0, {0, 0});
                  return true;
                }),
      to_device("the event timer has no effect", {"tpdo-17"},
                [](Middle& middle, Frame& frame) {
                  const bool is_it = is_download(middle, frame, 0x1800) && frame.data[3] == 5;
                  if (is_it && frame.data[4] == 100) frame.data[4] = 0;
                  return true;
                }),
  };
}

std::vector<Way> sync_ways() {
  constexpr std::uint32_t sync_id = 0x6B2;
  return {
      from_device("each second SYNC is lost", {"sync-05"},
                  [](Middle& middle, Frame& frame) {
                    const bool is_plain_sync = frame.id == sync_id && frame.length == 0;
                    return !is_plain_sync || ++middle.count % 2 != 0;
                  }),
      to_device("SYNC go on without bit 30", {"sync-06"},
                [](Middle& middle, Frame& frame) {
                  const bool was_producer = (middle.value(0x1005) & CobId::bit30) != 0;
                  const bool is_set = is_download(middle, frame, 0x1005);
                  const bool is_off = is_set && (frame.data[7] & 0x40) == 0;
                  if (is_set) middle.cancel_later();
                  if (is_off && was_producer) middle.add_later(30ms, sync_id, {});
                  return true;
                }),
      takes("the CAN-ID of a SYNC producer changes", {"sync-07"}, 0x1005,
            [](const Middle& middle, const Frame&) { return was_asked(middle, 0x4000'06BA); }),
      to_device("SYNC go on in stopped", {"sync-08"},
                [](Middle& middle, Frame& frame) {
                  const bool is_producer = (middle.value(0x1005) & CobId::bit30) != 0;
                  const bool is_stop = frame.id == can_id::nmt && frame.data[0] == 2;
                  if (is_stop && is_producer) middle.add_later(50ms, sync_id, {});
                  return true;
                }),
      takes("1019h takes 241", {"sync-09"}, 0x1019,
            [](const Middle&, const Frame& frame) {
              return !is_code(frame, AbortCode::device_state);
            }),
      from_device("SYNC always has counter 1", {"sync-10"},
                  [](Middle&, Frame& frame) {
                    if (frame.id == sync_id && frame.length == 1) frame.data[0] = 1;
                    return true;
                  }),
      takes("1019h changes with a period", {"sync-11"}, 0x1019,
            [](const Middle&, const Frame& frame) {
              return is_code(frame, AbortCode::device_state);
            }),
  };
}

std::vector<Way> all_ways() {
  std::vector<Way> all;
  for (auto&& ways : {sdo_ways(), dictionary_ways(), guarding_ways(), state_ways(), rpdo_ways(),
                      tpdo_ways(), sync_ways()}) {
    all.insert(all.end(), ways.begin(), ways.end());
  }
  return all;
}

Report check_communication(NodeOnLine& device) {
  Check check(device.line(), device.node(),
              {.moves = true, .sheet = &CommunicationDevice::sheet()});
  return check.run();
}

TEST(BrokenCommunication, OfNoneIsFoundInAWholeDevice) {
  CommunicationDevice device;
  const Report report = check_communication(device);
  EXPECT_TRUE(report.is_whole);
  EXPECT_THAT(report.notes, ::testing::IsEmpty());
  for (const TestResult& each : report.results) {
    EXPECT_NE(each.verdict.outcome, Outcome::failed) << each.test->id << ": " << each.verdict.why;
  }
}

TEST(BrokenCommunication, IsFoundByTheCasesThatAreAboutIt) {
  for (const Way& way : all_ways()) {
    CommunicationDevice device;
    Middle middle(device);
    apply(device, middle, way);
    EXPECT_THAT(failures(check_communication(device)),
                ::testing::UnorderedElementsAreArray(way.found_by))
        << way.name;
  }
}

/// A sheet without a mandatory object is none.
TEST(BrokenCommunication, OfTheSheetIsFound) {
  formats::DataSheet sheet = CommunicationDevice::sheet();
  sheet.objects.erase(0x1001);
  CommunicationDevice device;
  Check check(device.line(), device.node(), {.sheet = &sheet});
  EXPECT_THAT(failures(check.run()), ::testing::UnorderedElementsAre("eds-01", "dictionary-11"));
}

}  // namespace
}  // namespace canvoy::conformance::broken_communication_test

namespace canvoy::conformance {

std::vector<Way> communication_ways() {
  return broken_communication_test::all_ways();
}

}  // namespace canvoy::conformance
