// Further devices with one defect each, of details that implementers get wrong: found by the cases
// that concern it, and by no other.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "canvoy/canopen/protocol/little_endian.hpp"
#include "canvoy/text/check/report_text.hpp"
#include "canvoy/text/check/testing/module.hpp"

namespace canvoy::conformance::more_broken_test {
namespace {

bool is_answer_of(const Middle& middle, const Frame& frame, std::uint8_t command,
                  std::uint16_t index, std::uint8_t sub) {
  return frame.id == middle.answers() && frame.data[0] == command && index_of(frame) == index &&
         frame.data[3] == sub;
}

std::vector<Way> sdo_ways() {
  return {
      {"an abort names another object",
       {"sdo-04", "sdo-07"},
       [](Middle& middle, Frame& frame) {
         const bool is_refused = frame.id == middle.answers() && frame.data[0] == 0x80;
         if (is_refused && index_of(frame) == 0x0FFF) frame.data[1] = 0;
         return true;
       }},
      {"the answer for 1000h has seven bytes",
       {"sdo-01", "sdo-25", "dictionary-01"},
       [](Middle& middle, Frame& frame) {
         if (is_answer_of(middle, frame, 0x43, 0x1000, 0)) frame.length = 7;
         return true;
       }},
      {"the last segment has one byte too few",
       {"sdo-24"},
       [](Middle& middle, Frame& frame) {
         const bool is_segment = frame.id == middle.answers() && frame.data[0] < 0x20 &&
                                 (middle.last_request.data[0] & 0xEF) == 0x60;
         const bool is_last = (frame.data[0] & 1) != 0;
         if (is_segment && is_last && frame.data[0] < 0x1E) {
           frame.data[0] = static_cast<std::uint8_t>(frame.data[0] + 2);
         }
         return true;
       }},
      {"it answers requests to nobody",
       {"sdo-29"},
       {},
       [](Middle& middle, Frame& frame) {
         if (frame.id == can_id::sdo_request) {
           middle.add(middle.answers(), {0x43, 0, 0x10, 0, 0, 0, 0, 0});
         }
         return true;
       }},
  };
}

/// Passes a heartbeat 30 ms late; false: it must not be passed at once.
bool pass_heartbeat_late(Middle& middle, const Frame& frame) {
  if (frame.id != middle.states() || frame.data[0] == 0) return true;
  middle.add_later(30ms, frame.id, {frame.data[0]});
  return false;
}

std::vector<Way> other_ways() {
  return {
      {"its boot-up message has two bytes",
       {"nmt-04", "nmt-05", "nmt-06"},
       [](Middle& middle, Frame& frame) {
         if (frame.id == middle.states() && frame.data[0] == 0) frame.length = 2;
         return true;
       }},
      {"its heartbeats have a toggle bit",
       {"heartbeat-04"},
       [](Middle& middle, Frame& frame) {
         if (frame.id == middle.states() && frame.data[0] != 0) frame.data[0] |= 0x80U;
         return true;
       }},
      // They tell no state: no case that looks at the state passes.
      {"its heartbeats have eight bytes",
       {"nmt-01", "nmt-02", "nmt-03", "nmt-07", "nmt-08", "nmt-09", "heartbeat-01", "heartbeat-02"},
       [](Middle& middle, Frame& frame) {
         if (frame.id == middle.states() && frame.data[0] != 0) frame.length = 8;
         return true;
       }},
      {"the event timer runs twice as long",
       {"tpdo-17"},
       {},
       [](Middle& middle, Frame& frame) {
         if (is_download(middle, frame, 0x1800) && frame.data[3] == 5) {
           const auto ms = load<std::uint16_t>(&frame.data[4]);
           store(&frame.data[4], static_cast<std::uint16_t>(ms * 2));
         }
         return true;
       }},
      {"an emergency has seven bytes",
       {"emergency-02"},
       [](Middle& middle, Frame& frame) {
         if (frame.id == middle.emergencies()) frame.length = 7;
         return true;
       }},
  };
}

std::vector<Way> all_of_them() {
  std::vector<Way> all = sdo_ways();
  for (const Way& each : other_ways()) all.push_back(each);
  return all;
}

TEST(MoreBrokenDevices, AreFoundByTheCasesThatAreAboutIt) {
  for (const Way& way : all_of_them()) expect_found_in_module(way);
}

TEST(MoreBrokenDevices, HaveTheirFailuresAtTheTopOfThePage) {
  CheckedDevice device(module_kind());
  Middle middle(device);
  const std::vector<Way> ways = sdo_ways();
  apply(device, middle, ways.front());
  Check check(device.line(), device.node(), {});
  const std::string page = report_html({}, check.run({}, "sdo"));
  const std::size_t link = page.find("<li><a href=\"#sdo-04\">sdo-04</a>");
  ASSERT_NE(link, std::string::npos);
  EXPECT_LT(link, page.find("<h2>SDO"));
  EXPECT_NE(page.find("<tr id=\"sdo-04\" class=\"fail\">"), std::string::npos);
}

/// A bus or a listener that is busy for a moment is no defect of the device.
TEST(MoreBrokenDevices, AreNotThoseWithOneHeartbeatThatIsLate) {
  CheckedDevice device(module_kind());
  Middle middle(device);
  const Way way = {"", {}, [](Middle& party, Frame& frame) {
                     const bool is_heartbeat = frame.id == party.states() && frame.data[0] != 0;
                     const bool is_of_case = party.value(0x1017) == 200;
                     if (!is_heartbeat || !is_of_case || ++party.count != 5) return true;
                     return pass_heartbeat_late(party, frame);
                   }};
  apply(device, middle, way);
  Check check(device.line(), device.node(), {});
  EXPECT_THAT(failures(check.run({}, "heartbeat-02")), ::testing::IsEmpty());
  EXPECT_GT(middle.count, 5U);
}

}  // namespace
}  // namespace canvoy::conformance::more_broken_test
