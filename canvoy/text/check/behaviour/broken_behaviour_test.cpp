// Devices with a deliberate defect: each defect is found by the cases that concern it, and by no
// other.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "canvoy/text/check/testing/all_ways.hpp"
#include "canvoy/text/check/testing/broken_device.hpp"

namespace canvoy::conformance::broken_behaviour_test {
namespace {

/// A command for door 1 by RPDO: in the upper four bits of its second byte.
bool is_door_command(const Frame& frame, unsigned command) {
  return (frame.id == 0x200 || frame.id == 0x6B3) && frame.length == 8 &&
         frame.data[1] >> 4 == command;
}
void change_door_command(Frame& frame, unsigned command) {
  frame.data[1] = static_cast<std::uint8_t>((frame.data[1] & 0x0F) | command << 4);
}
Way door_command(std::string_view name, std::vector<std::string_view> found_by, unsigned command,
                 unsigned becomes) {
  return {name, std::move(found_by), {}, [command, becomes](Middle&, Frame& frame) {
            if (is_door_command(frame, command)) change_door_command(frame, becomes);
            return true;
          }};
}

constexpr unsigned no_action = 0xF;
constexpr unsigned open_it = 0x4;

std::vector<BrokenDevice> lift_ways() {
  return {
      {"lift-door",
       door_command("a door opens by a reserved command", {"417-4-door-10"}, 0x2, open_it)},
      {"lift-door",
       door_command("another reserved command opens it", {"417-4-door-11"}, 0x6, open_it)},
      {"lift-door", door_command("and another one", {"417-4-door-12"}, 0xD, open_it)},
      {"lift-door", door_command("it does not open without a limit of its force", {"417-4-door-07"},
                                 0x3, no_action)},
      {"lift-door", door_command("it does not close without a limit of its force",
                                 {"417-4-door-08"}, 0x0, no_action)},
      {"lift-door", door_command("it does not stop", {"417-4-door-05"}, 0x8, no_action)},
      {"lift-door", to_device("it takes the commands of door 2", {"417-4-door-13"},
                              [](Middle&, Frame& frame) {
                                const bool is_command =
                                    is_door_command(frame, no_action) || is_door_command(frame, 1);
                                if (is_command && frame.data[3] >> 4 == open_it)
                                  change_door_command(frame, open_it);
                                return true;
                              })},
      {"lift-door",
       from_device(
           "it does not tell that it opens", {"417-4-door-03", "417-4-door-15"},
           [](Middle&, Frame& frame) { return frame.id != 0x201 || frame.data[1] >> 4 != 5; })},
      {"lift-call-controller", to_device("it serves the calls of lift 2", {"417-4-call-07"},
                                         [](Middle&, Frame& frame) {
                                           if (frame.length == 6 && frame.data[2] == 2)
                                             frame.data[2] = 1;
                                           return true;
                                         })},
      {"lift-call-controller", to_device("a button that is let go is a call", {"417-4-call-08"},
                                         [](Middle&, Frame& frame) {
                                           if (frame.length == 6 && frame.data[0] == 2 &&
                                               frame.data[5] == 0)
                                             frame.data[5] = 1;
                                           return true;
                                         })},
      {"lift-call-controller",
       from_device("it affirms a call to a floor that there is not", {"417-4-call-13"},
                   [](Middle&, Frame& frame) {
                     if (frame.length == 6 && frame.data[3] == 0xFE) frame.data[5] = 0x81;
                     return true;
                   })},
      {"lift-load", from_device("it sets a reserved bit", {"417-4-load-08"},
                                [](Middle& middle, Frame& frame) {
                                  if (is_upload(middle, frame, 0x6482) && frame.data[3] == 1)
                                    frame.data[4] |= 0x80U;
                                  return true;
                                })},
      {"lift-position",
       to_device("a preset is another one", {"417-4-position-01", "417-4-position-02"},
                 [](Middle& middle, Frame& frame) {
                   if (is_download(middle, frame, 0x6382)) frame.data[4] ^= 1U;
                   return true;
                 })},
  };
}

std::vector<BrokenDevice> car_and_bus_ways() {
  return {
      {"radio", to_device("it is not turned off",
                          {"447-3-radio-02", "447-3-radio-04", "447-3-radio-05", "447-3-radio-08"},
                          [](Middle& middle, Frame& frame) {
                            if (is_download(middle, frame, 0x6116) && frame.data[4] == 0xFC)
                              frame.data[4] = 0xFF;
                            return true;
                          })},
      {"radio", from_device("it says that it takes a reserved command", {"447-3-radio-06"},
                            [](Middle&, Frame& frame) {
                              if (is_abort(frame, 0x6116, AbortCode::value_range))
                                say_written(frame);
                              return true;
                            })},
      {"radio", to_device("\"do not care\" turns it off", {"447-3-radio-07"},
                          [](Middle& middle, Frame& frame) {
                            if (is_download(middle, frame, 0x6116) && frame.data[4] == 0xFF)
                              frame.data[4] = 0xFC;
                            return true;
                          })},
      {"blue-light", from_device("reserved bits of its status are 0", {"447-3-blue-light-07"},
                                 [](Middle& middle, Frame& frame) {
                                   if (is_upload(middle, frame, 0x6141)) {
                                     frame.data[6] &= 0x0F;
                                     frame.data[7] = 0;
                                   }
                                   return true;
                                 })},
      {"taximeter",
       from_device("it says that it takes the pulses of a stranger", {"447-3-taximeter-01"},
                   [](Middle& middle, Frame& frame) {
                     if (frame.id == middle.answers() && frame.data[0] == 0x80 &&
                         index_of(frame) == 0x6055) {
                       say_written(frame);
                     }
                     return true;
                   })},
      {"next-stop-indicator-text",
       from_device("it says that it takes a character set that there is not",
                   {"407-display-09", "407-display-10"},
                   [](Middle&, Frame& frame) {
                     if (is_abort(frame, 0x6205, AbortCode::value_range)) say_written(frame);
                     return true;
                   })},
      {"ticket-canceller", to_device("it takes the events of another device", {"407-event-05"},
                                     [](Middle&, Frame& frame) {
                                       constexpr std::uint8_t canceller = 0x04;
                                       const bool is_rpdo = frame.id > 0x180 && frame.id < 0x6C0 &&
                                                            frame.length == 4;
                                       if (is_rpdo && !frame.is_remote()) frame.data[3] = canceller;
                                       return true;
                                     })},
      {"operator", from_device("its warning is lost", {"852-alarm-01", "852-alarm-02"},
                               [](Middle& middle, Frame& frame) {
                                 return frame.id != middle.emergencies() || frame.data[0] != 0x80 ||
                                        frame.data[1] != 0;
                               })},
      {"operator", from_device("reserved bits of a memory function are 1", {"852-joystick-10"},
                               [](Middle& middle, Frame& frame) {
                                 if (is_upload(middle, frame, 0x6000) && frame.data[3] == 1)
                                   frame.data[4] |= 0x80U;
                                 return true;
                               })},
  };
}

/// True for the charger's upload request of an entry of its battery (node-ID 127).
bool asks_battery(const Frame& frame, std::uint16_t index, std::uint8_t sub) {
  return frame.id == can_id::sdo_request + node_id_max && frame.data[0] == 0x40 &&
         index_of(frame) == index && frame.data[3] == sub;
}
/// Answers the charger in place of its battery, which gets no request: what the charger takes for
/// granted. `command` is that of an expedited upload of its bytes; false: the request is lost.
bool is_taken_for_granted(Middle& middle, const Frame& asked, std::uint32_t number,
                          std::uint8_t command = 0x43) {
  Frame answer =
      Frame::data_frame(can_id::sdo_response + node_id_max,
                        {command, asked.data[1], asked.data[2], asked.data[3], 0, 0, 0, 0});
  store(&answer.data[4], number);
  middle.tell_device(answer);
  return false;
}

std::vector<BrokenDevice> charger_link_ways() {
  return {
      {"charger",
       {"it takes the first node for a battery module",
        {"419-link-01"},
        [](Middle& middle, Frame& frame) {
          constexpr std::uint32_t battery_module = 418;
          return !asks_battery(frame, 0x1000, 0) ||
                 is_taken_for_granted(middle, frame, battery_module);
        }}},
      {"charger",
       {"it sends with the battery's default COB-IDs, which it does not read",
        {"419-link-02"},
        [](Middle& middle, Frame& frame) {
          for (const std::uint16_t rpdo :
               {std::uint16_t{0x1400}, std::uint16_t{0x1401}, std::uint16_t{0x1402}}) {
            if (!asks_battery(frame, rpdo, 1)) continue;
            return is_taken_for_granted(middle, frame, rpdo == 0x1400 ? 0x27FU : CobId::bit31);
          }
          return true;
        }}},
      {"charger",
       {"it does not read what was returned during the charge before",
        {"419-link-07"},
        [](Middle& middle, Frame& frame) {
          return !asks_battery(frame, 0x6052, 0) || is_taken_for_granted(middle, frame, 0, 0x4B);
        }}},
  };
}

std::vector<BrokenDevice> charger_ways() {
  return {
      {"charger", from_device("it never says that it is ready", {"419-status-03"},
                              [](Middle& middle, Frame& frame) {
                                if (is_upload(middle, frame, 0x6001)) frame.data[4] = 0;
                                return true;
                              })},
      {"charger", from_device("each second status is lost", {"419-status-01"},
                              [](Middle& middle, Frame& frame) {
                                return frame.id != 0x27F || ++middle.count % 2 != 0;
                              })},
      {"charger",
       from_device("it says that it stays operational without its battery", {"419-loss-01"},
                   [](Middle& middle, Frame& frame) {
                     if (frame.id == middle.states() && frame.data[0] == 0x7F) frame.data[0] = 5;
                     return true;
                   })},
      {"charger", from_device("it does not tell that its battery is lost", {"419-loss-02"},
                              [](Middle& middle, Frame& frame) {
                                return frame.id != middle.emergencies() || frame.data[1] != 0x81;
                              })},
      {"charger", from_device("it counts on though no current is asked for",
                              {"419-charge-02", "419-charge-03", "419-charge-04", "419-charge-05"},
                              [](Middle& middle, Frame& frame) {
                                if (is_upload(middle, frame, 0x6052)) {
                                  store(&frame.data[4], static_cast<std::uint16_t>(++middle.count));
                                }
                                return true;
                              })},
      {"charger", from_device("it counts more than the battery asks for",
                              {"419-charge-01", "419-charge-02", "419-charge-03", "419-charge-04",
                               "419-charge-05"},
                              [](Middle& middle, Frame& frame) {
                                if (is_upload(middle, frame, 0x6052)) {
                                  store(&frame.data[4],
                                        static_cast<std::uint16_t>(++middle.count * 100));
                                }
                                return true;
                              })},
      {"charger", from_device("it does not write back what was returned", {"419-charge-06"},
                              [](Middle&, Frame& frame) {
                                const bool is_download =
                                    (frame.data[0] & 0xE0) == 0x20 && index_of(frame) == 0x6052;
                                return frame.id != can_id::sdo_request + node_id_max ||
                                       !is_download;
                              })},
      {"charger", from_device("its TPDOs have other COB-IDs than the RPDOs of the battery",
                              {"419-link-04", "419-status-01", "419-status-02"},
                              [](Middle& middle, Frame& frame) {
                                const bool is_tpdo =
                                    index_of(frame) >= 0x1800 && index_of(frame) <= 0x1802;
                                if (is_tpdo && is_upload(middle, frame, index_of(frame)) &&
                                    frame.data[3] == 1) {
                                  frame.data[4] ^= 1U;
                                }
                                return true;
                              })},
      {"charger",
       {"it takes a state of charge beyond 100 %",
        {"419-battery-10"},
        [](Middle& middle, Frame& frame) {
          if (is_upload(middle, frame, 0x6081) && middle.count != 0) frame.data[4] = 0x65;
          return true;
        },
        [](Middle& middle, Frame& frame) {
          if (frame.id < can_id::sdo_response && frame.length == 3) {
            middle.count = frame.data[2] == 0x65 ? 1 : 0;
          }
          return true;
        }}},
      {"charger", to_device("it leaves operational whatever 1029h says", {"419-loss-03"},
                            [](Middle& middle, Frame& frame) {
                              if (is_download(middle, frame, 0x1029)) frame.data[4] = 0;
                              return true;
                            })},
      {"charger", from_device("its PDOs are valid without a battery",
                              {"419-link-03", "419-link-05", "419-link-06"},
                              [](Middle& middle, Frame& frame) {
                                const bool is_rpdo = is_upload(middle, frame, 0x1400) ||
                                                     is_upload(middle, frame, 0x1401);
                                if (is_rpdo && frame.data[3] == 1) frame.data[7] &= 0x7F;
                                return true;
                              })},
  };
}

std::vector<BrokenDevice> all_ways() {
  std::vector<BrokenDevice> all = lift_ways();
  for (auto&& ways : {car_and_bus_ways(), charger_ways(), charger_link_ways()}) {
    all.insert(all.end(), ways.begin(), ways.end());
  }
  return all;
}

TEST(BrokenBehaviour, IsFoundByTheCasesThatAreAboutIt) {
  const std::vector<BrokenDevice> all = all_ways();
  EXPECT_GE(all.size(), 25U);
  for (const BrokenDevice& broken : all) expect_found(broken);
}

/// The replaced part is a door that does not move: the case fails at the command, and the test
/// ends.
TEST(BrokenBehaviour, OfADoorThatStandsStillIsSaid) {
  Workshop workshop;
  workshop.door.is_blocked = true;
  const DeviceKind& kind = *find_device_kind("lift-door");
  CheckedDevice device(kind, workshop.environment);
  Check check(device.line(), device.node(), {.moves = true, .profile = kind.profile});
  const Report report = check.run({}, "417-4-door-01");
  EXPECT_THAT(failures(report), ::testing::ElementsAre("417-4-door-01"));
}

}  // namespace
}  // namespace canvoy::conformance::broken_behaviour_test

namespace canvoy::conformance {

std::vector<BrokenDevice> behaviour_ways() {
  return broken_behaviour_test::all_ways();
}

}  // namespace canvoy::conformance
