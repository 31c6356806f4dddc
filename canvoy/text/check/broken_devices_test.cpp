// Devices with a deliberate defect, made by a party on the line that changes, drops and adds
// frames: each defect is found by the cases that concern it, and by no other.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "canvoy/canopen/protocol/little_endian.hpp"
#include "canvoy/text/check/testing/all_ways.hpp"
#include "canvoy/text/check/testing/module.hpp"

namespace canvoy::conformance::broken_devices_test {
namespace {

constexpr NodeId any_node = 0;

std::vector<Way> sdo_ways() {
  return {
      from_device("another abort code for what is not there", {"sdo-04", "sdo-07"},
                  [](Middle&, Frame& frame) {
                    if (is_abort(frame, 0x0FFF, AbortCode::no_object)) {
                      change_code(frame, AbortCode::unsupported_access);
                    }
                    return true;
                  }),
      from_device("a sub-index that is not there is an object that is not there",
                  {"sdo-05", "sdo-08"},
                  [](Middle&, Frame& frame) {
                    if (is_abort(frame, 0x1018, AbortCode::no_sub_index)) {
                      change_code(frame, AbortCode::no_object);
                    }
                    return true;
                  }),
      from_device("a variable has a sub-index 01h", {"sdo-06"},
                  [](Middle&, Frame& frame) {
                    if (is_abort(frame, 0x1000, AbortCode::no_sub_index)) frame.data[0] = 0x43;
                    return true;
                  }),
      from_device("what is read only cannot be accessed", {"sdo-09", "sdo-10", "dictionary-05"},
                  [](Middle&, Frame& frame) {
                    if (is_abort(frame, 0x1000, AbortCode::read_only)) {
                      change_code(frame, AbortCode::unsupported_access);
                    }
                    return true;
                  }),
      from_device("a command that there is not is general trouble", {"sdo-11"},
                  [](Middle& middle, Frame& frame) {
                    if (frame.id == middle.answers() && middle.last_request.data[0] == 0xE0) {
                      change_code(frame, AbortCode::general);
                    }
                    return true;
                  }),
      from_device("a toggle bit that stands still", {"sdo-24"},
                  [](Middle& middle, Frame& frame) {
                    const bool is_segment = frame.id == middle.answers() &&
                                            (middle.last_request.data[0] & 0xEF) == 0x60;
                    if (is_segment && frame.data[0] < 0x20) frame.data[0] &= 0xEF;
                    return true;
                  }),
      from_device("one byte more is announced than comes", {"sdo-24"},
                  [](Middle& middle, Frame& frame) {
                    if (frame.id == middle.answers() && frame.data[0] == 0x41) ++frame.data[4];
                    return true;
                  }),
      to_device("an abort is answered", {"sdo-14", "sdo-21", "sdo-23"},
                [](Middle& middle, Frame& frame) {
                  if (frame.id == middle.requests() && frame.data[0] == 0x80) {
                    middle.add(middle.answers(), {0x80, 0, 0, 0, 0, 0, 0, 8});
                  }
                  return true;
                }),
      to_device("a remote frame is answered", {"sdo-30"},
                [](Middle& middle, Frame& frame) {
                  if (frame.id == middle.requests() && frame.is_remote()) {
                    middle.add(middle.answers(), {0x80, 0, 0, 0, 0, 0, 0, 8});
                  }
                  return true;
                }),
      to_device("requests to another node are answered", {"sdo-29"},
                [](Middle& middle, Frame& frame) {
                  if (frame.id == middle.requests() + 1) {
                    middle.add(middle.answers(), {0x43, 0, 0x10, 0, 0, 0, 0, 0});
                  }
                  return true;
                }),
      from_device("a second answer to 1000h", {"sdo-31"},
                  [](Middle& middle, Frame& frame) {
                    if (frame.id == middle.answers() && frame.data[0] == 0x43 &&
                        index_of(frame) == 0x1000) {
                      middle.repeat(frame);
                    }
                    return true;
                  }),
  };
}

std::vector<Way> dictionary_ways() {
  return {
      from_device("1001h has two bytes", {"sdo-02", "dictionary-01", "dictionary-06"},
                  [](Middle& middle, Frame& frame) {
                    if (frame.id == middle.answers() && frame.data[0] == 0x4F &&
                        index_of(frame) == 0x1001) {
                      frame.data[0] = 0x4B;
                    }
                    return true;
                  }),
      from_device("another product code than in the data sheet, and than by LSS",
                  {"dictionary-07", "lss-01"},
                  [](Middle& middle, Frame& frame) {
                    if (frame.id == middle.answers() && frame.data[0] == 0x43 &&
                        index_of(frame) == 0x1018 && frame.data[3] == 2) {
                      frame.data[4] ^= 1U;
                    }
                    return true;
                  }),
      from_device("1018h can be written", {"dictionary-05"},
                  [](Middle&, Frame& frame) {
                    if (is_abort(frame, 0x1018, AbortCode::read_only)) say_written(frame);
                    return true;
                  }),
      from_device("1018h:00h says one entry less", {"dictionary-07", "dictionary-10"},
                  [](Middle& middle, Frame& frame) {
                    if (frame.id == middle.answers() && frame.data[0] == 0x4F &&
                        index_of(frame) == 0x1018) {
                      --frame.data[4];
                    }
                    return true;
                  }),
      from_device("1018h:03h is not there", {"dictionary-02", "lss-01"},
                  [](Middle& middle, Frame& frame) {
                    if (frame.id == middle.answers() && index_of(frame) == 0x1018 &&
                        frame.data[3] == 3) {
                      frame.data[0] = 0x80;
                      change_code(frame, AbortCode::no_sub_index);
                    }
                    return true;
                  }),
  };
}

std::vector<Way> state_ways() {
  return {
      from_device("a boot-up message is lost", {"nmt-04", "nmt-05", "nmt-06"},
                  [](Middle& middle, Frame& frame) {
                    return !(frame.id == middle.states() && frame.length == 1 &&
                             frame.data[0] == 0);
                  }),
      from_device("a boot-up message has two bytes", {"nmt-04", "nmt-05", "nmt-06"},
                  [](Middle& middle, Frame& frame) {
                    if (frame.id == middle.states() && frame.data[0] == 0) frame.length = 2;
                    return true;
                  }),
      from_device("operational is told as pre-operational", {"nmt-02", "nmt-07", "heartbeat-04"},
                  [](Middle& middle, Frame& frame) {
                    if (frame.id == middle.states() && frame.data[0] == 5) frame.data[0] = 0x7F;
                    return true;
                  }),
      to_device("SDO is served in stopped", {"nmt-03"},
                [](Middle& middle, Frame& frame) {
                  if (frame.id == middle.requests() && middle.state() == NmtState::stopped) {
                    middle.add(middle.answers(), {0x43, 0, 0x10, 0, 0, 0, 0, 0});
                  }
                  return true;
                }),
      to_device("a command for another node is followed", {"nmt-08"},
                [](Middle& middle, Frame& frame) {
                  if (frame.id == can_id::nmt && frame.data[1] != any_node)
                    frame.data[1] = middle.node();
                  return true;
                }),
      to_device("command 03h starts the node", {"nmt-09"},
                [](Middle&, Frame& frame) {
                  if (frame.id == can_id::nmt && frame.data[0] == 3) frame.data[0] = 1;
                  return true;
                }),
      from_device("each third heartbeat is lost", {"heartbeat-01", "heartbeat-02"},
                  [](Middle& middle, Frame& frame) {
                    const bool is_beat = frame.id == middle.states() && frame.data[0] == 0x7F;
                    return !is_beat || ++middle.count % 3 != 0;
                  }),
      to_device("heartbeats go on with 1017h = 0", {"heartbeat-03"},
                [](Middle& middle, Frame& frame) {
                  const bool is_off = frame.id == middle.requests() && frame.data[0] == 0x2B &&
                                      index_of(frame) == 0x1017 && frame.data[4] == 0 &&
                                      frame.data[5] == 0;
                  if (is_off) frame.data[4] = 50;
                  return true;
                }),
  };
}

std::vector<Way> emergency_ways() {
  return {
      from_device("an emergency has seven bytes", {"emergency-02"},
                  [](Middle& middle, Frame& frame) {
                    if (frame.id == middle.emergencies() && frame.length == 8) frame.length = 7;
                    return true;
                  }),
      from_device("an emergency tells no error register", {"emergency-03"},
                  [](Middle& middle, Frame& frame) {
                    if (frame.id == middle.emergencies() && frame.length == 8) frame.data[2] = 0;
                    return true;
                  }),
      from_device("the end of an error is not told", {"emergency-08"},
                  [](Middle& middle, Frame& frame) {
                    return frame.id != middle.emergencies() || frame.length != 8 ||
                           frame.data[1] != 0;
                  }),
      from_device("an emergency of another code", {"heartbeat-05", "emergency-04"},
                  [](Middle& middle, Frame& frame) {
                    const bool is_lost = frame.id == middle.emergencies() && frame.length == 8 &&
                                         frame.data[1] == 0x81 && frame.data[0] == 0x30;
                    if (is_lost) frame.data[0] = 0x40;
                    return true;
                  }),
      from_device("1003h:00h takes 1", {"emergency-06"},
                  [](Middle& middle, Frame& frame) {
                    const bool is_one = middle.last_request.data[4] == 1;
                    if (is_one && is_abort(frame, 0x1003, AbortCode::value_range))
                      say_written(frame);
                    return true;
                  }),
      from_device("1014h takes what is restricted", {"can-id-03"},
                  [](Middle&, Frame& frame) {
                    if (is_abort(frame, 0x1014, AbortCode::value_range)) say_written(frame);
                    return true;
                  }),
  };
}

std::vector<Way> pdo_ways() {
  const auto is_tpdo = [](const Frame& frame) { return frame.id == 0x6B0 && frame.is_plain(); };
  return {
      from_device("a TPDO is a byte too short", {"tpdo-12"},
                  [is_tpdo](Middle&, Frame& frame) {
                    if (is_tpdo(frame)) --frame.length;
                    return true;
                  }),
      from_device("a TPDO carries something else", {"tpdo-13"},
                  [is_tpdo](Middle&, Frame& frame) {
                    if (is_tpdo(frame)) frame.data[0] ^= 1U;
                    return true;
                  }),
      to_device("a TPDO comes in pre-operational", {"tpdo-14"},
                [](Middle& middle, Frame& frame) {
                  if (frame.id == can_id::sync && middle.state() == NmtState::pre_operational) {
                    middle.add(0x6B0, {0});
                  }
                  return true;
                }),
      to_device("a TPDO comes in stopped", {"tpdo-15"},
                [](Middle& middle, Frame& frame) {
                  if (frame.id == can_id::sync && middle.state() == NmtState::stopped) {
                    middle.add(0x6B0, {0});
                  }
                  return true;
                }),
      from_device("a reserved transmission type is taken", {"tpdo-04"},
                  [](Middle&, Frame& frame) {
                    const bool is_type = frame.data[3] == 2 && index_of(frame) >= 0x1800;
                    if (is_type && is_abort(frame, index_of(frame), AbortCode::value_range)) {
                      say_written(frame);
                    }
                    return true;
                  }),
      from_device("a TPDO comes twice",
                  {"tpdo-18", "tpdo-19", "sync-01", "sync-02", "sync-03", "sync-04"},
                  [is_tpdo](Middle& middle, Frame& frame) {
                    if (is_tpdo(frame)) middle.repeat(frame);
                    return true;
                  }),
      from_device("an RPDO that is too short is no emergency", {"rpdo-12"},
                  [](Middle& middle, Frame& frame) {
                    return frame.id != middle.emergencies() || frame.data[1] != 0x82;
                  }),
  };
}

std::vector<Way> all_ways() {
  std::vector<Way> all;
  for (auto&& ways : {sdo_ways(), dictionary_ways(), state_ways(), emergency_ways(), pdo_ways()}) {
    all.insert(all.end(), ways.begin(), ways.end());
  }
  return all;
}

TEST(BrokenDevices, AreFoundByTheCasesThatAreAboutThem) {
  const std::vector<Way> ways = all_ways();
  EXPECT_GE(ways.size(), 37U);
  for (const Way& way : ways) expect_found_in_module(way);
}

TEST(BrokenDevices, ThatAreSilentAreNotTried) {
  CheckedDevice device(module_kind());
  device.to_device = [](Frame&) { return false; };
  Check check(device.line(), device.node(), {});
  const Report report = check.run();
  EXPECT_FALSE(report.has_answered);
  EXPECT_TRUE(report.results.empty());
}

/// The device fails at the first request for a missing object: that case fails, and the others do
/// not apply.
TEST(BrokenDevices, ThatDieAreToldByTheCaseThatKilledThem) {
  CheckedDevice device(module_kind());
  bool is_dead = false;
  device.to_device = [&](Frame& frame) {
    is_dead = is_dead || (frame.id == can_id::sdo_request + std::uint32_t{device.node()} &&
                          frame.data[0] == 0x40 && index_of(frame) == 0x0FFF);
    return !is_dead;
  };
  device.from_device = [&](Frame&) { return !is_dead; };
  Check check(device.line(), device.node(), {});
  const Report report = check.run();
  EXPECT_THAT(failures(report), ::testing::ElementsAre("sdo-04"));
  EXPECT_EQ(report.results.back().verdict.why, "the device is silent since sdo-04");
  EXPECT_THAT(report.notes, ::testing::Contains(::testing::HasSubstr("since sdo-04")));
}

TEST(BrokenDevices, OnABusThatTakesNoFramesAreLeft) {
  CheckedDevice device(module_kind());
  unsigned frames = 0;
  device.to_device = [&](Frame&) {
    device.is_bus_off = ++frames > 100;
    return true;
  };
  Check check(device.line(), device.node(), {});
  const Report report = check.run();
  EXPECT_TRUE(report.has_answered);
  EXPECT_FALSE(report.is_whole);
  EXPECT_EQ(report.count(Outcome::failed), 0U);
}

/// Interruptions at many moments of the test: communication parameters and state are restored.
TEST(BrokenDevices, NoneIsMadeByAnInterruption) {
  constexpr std::pair<std::uint16_t, std::uint8_t> settings[] = {
      {0x1014, 0}, {0x1016, 1}, {0x1017, 0}, {0x1400, 1}, {0x1400, 2}, {0x1800, 1},
      {0x1800, 2}, {0x1800, 3}, {0x1800, 5}, {0x1A00, 0}, {0x1A00, 1}};
  unsigned interrupted = 0;
  for (unsigned most = 2; most < 2400; most += most < 200 ? 7 : 37) {
    CheckedDevice device(module_kind());
    const auto all = [&] {
      std::vector<std::uint64_t> values;
      for (const auto& [index, sub] : settings) {
        const bool is_there = static_cast<bool>(device.device().dictionary().find(index, sub));
        values.push_back(is_there ? device.device().dictionary().number(index, sub) : 0);
      }
      return values;
    };
    const std::vector<std::uint64_t> before = all();
    const NmtState state = device.device().state();
    unsigned frames = 0;
    device.to_device = [&](Frame&) { return ++frames != 0; };
    Line line = device.line();
    line.is_interrupted = [&] { return frames > most; };
    Check check(std::move(line), device.node(), {});
    const Report report = check.run();
    if (!report.is_whole) ++interrupted;
    EXPECT_EQ(all(), before) << most;
    EXPECT_EQ(device.device().state(), state) << most;
    EXPECT_THAT(report.notes, ::testing::IsEmpty()) << most;
  }
  EXPECT_GT(interrupted, 5U);
}

/// With any answer of the device, the test ends, and the device is not reported as conforming.
TEST(BrokenDevices, ThatAnswerNonsenseDoNotPass) {
  for (std::uint32_t seed = 1; seed <= 3; ++seed) {
    CheckedDevice device(module_kind());
    std::uint32_t random = seed;
    device.from_device = [&](Frame& frame) {
      for (std::uint8_t& byte : frame.data) {
        random = random * 1664525U + 1013904223U;
        byte = static_cast<std::uint8_t>(random >> 24);
      }
      frame.length = static_cast<std::uint8_t>(random % 9);
      return (random >> 16 & 7U) != 0;
    };
    Check check(device.line(), device.node(), {});
    const Report report = check.run();
    if (report.has_answered) EXPECT_GT(report.count(Outcome::failed), 5U) << seed;
  }
}

}  // namespace
}  // namespace canvoy::conformance::broken_devices_test

namespace canvoy::conformance {

std::vector<Way> module_ways() {
  return broken_devices_test::all_ways();
}

}  // namespace canvoy::conformance
