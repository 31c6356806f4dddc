// Modules whose LSS has a deliberate defect (CiA 305): each is found by the cases that concern it,
// and by no other.
#include "canvoy/canopen/protocol/little_endian.hpp"
#include "canvoy/text/check/testing/all_ways.hpp"
#include "canvoy/text/check/testing/module.hpp"

namespace canvoy::conformance::broken_lss_test {
namespace {

std::vector<Way> lss_ways() {
  const auto is_answer = [](const Frame& frame, std::uint8_t command) {
    return frame.id == can_id::lss_response && frame.data[0] == command;
  };
  const auto is_request = [](const Frame& frame, std::uint8_t command) {
    return frame.id == can_id::lss_request && frame.data[0] == command;
  };
  return {
      to_device("no LSS, though its data sheet says so", {"lss-01"},
                [](Middle&, Frame& frame) { return frame.id != can_id::lss_request; }),
      from_device("another vendor-ID by LSS than by SDO", {"lss-03"},
                  [is_answer](Middle&, Frame& frame) {
                    if (is_answer(frame, 0x5A)) frame.data[1] ^= 1U;
                    return true;
                  }),
      from_device("another serial number by LSS than by SDO", {"lss-06"},
                  [is_answer](Middle&, Frame& frame) {
                    if (is_answer(frame, 0x5D)) frame.data[4] ^= 1U;
                    return true;
                  }),
      from_device("node-ID 128 is taken", {"lss-08"},
                  [is_answer](Middle& middle, Frame& frame) {
                    if (is_answer(frame, 0x11) && middle.last_lss_request.data[1] == 128)
                      frame.data[1] = 0;
                    return true;
                  }),
      from_device("its own node-ID is refused", {"lss-10"},
                  [is_answer](Middle& middle, Frame& frame) {
                    const bool is_own = middle.last_lss_request.data[1] == middle.node();
                    if (is_answer(frame, 0x11) && is_own) frame.data[1] = 1;
                    return true;
                  }),
      from_device("a reserved bit timing is taken", {"lss-11"},
                  [is_answer](Middle&, Frame& frame) {
                    if (is_answer(frame, 0x13)) frame.data[1] = 0;
                    return true;
                  }),
      to_device("an inquiry is answered in waiting", {"lss-12"},
                [is_request](Middle& middle, Frame& frame) {
                  if (is_request(frame, 0x5E) && frame.length == 8 && !middle.is_selected()) {
                    middle.add(can_id::lss_response, {0x5E, middle.node(), 0, 0, 0, 0, 0, 0});
                  }
                  return true;
                }),
      to_device("an LSS message of seven bytes is answered", {"lss-13"},
                [is_request](Middle& middle, Frame& frame) {
                  if (is_request(frame, 0x5E) && frame.length == 7) {
                    middle.add(can_id::lss_response, {0x5E, middle.node(), 0, 0, 0, 0, 0, 0});
                  }
                  return true;
                }),
      to_device("a device with a node-ID takes part in fastscan", {"lss-16"},
                [is_request](Middle& middle, Frame& frame) {
                  if (is_request(frame, 0x51)) {
                    middle.add(can_id::lss_response, {0x4F, 0, 0, 0, 0, 0, 0, 0});
                  }
                  return true;
                }),
      to_device("a device with a node-ID says that it has none", {"lss-15"},
                [is_request](Middle& middle, Frame& frame) {
                  if (is_request(frame, 0x4C)) {
                    middle.add(can_id::lss_response, {0x50, 0, 0, 0, 0, 0, 0, 0});
                  }
                  return true;
                }),
      to_device("it is found by any serial number", {"lss-18"},
                [is_request](Middle&, Frame& frame) {
                  // Ranges from 0 to FFFF FFFFh.
                  if (is_request(frame, 0x4A)) store(&frame.data[1], std::uint32_t{0});
                  if (is_request(frame, 0x4B)) store(&frame.data[1], ~std::uint32_t{0});
                  return true;
                }),
      to_device("it answers to another vendor's address", {"lss-02"},
                [is_request](Middle& middle, Frame& frame) {
                  if (is_request(frame, 0x40)) middle.count = load<std::uint32_t>(&frame.data[1]);
                  if (is_request(frame, 0x43) && middle.count != 0) {
                    middle.add(can_id::lss_response, {0x44, 0, 0, 0, 0, 0, 0, 0});
                  }
                  return true;
                }),
      from_device("another product code by LSS than by SDO", {"lss-04"},
                  [is_answer](Middle&, Frame& frame) {
                    if (is_answer(frame, 0x5B)) frame.data[1] ^= 1U;
                    return true;
                  }),
      from_device("another revision number by LSS than by SDO", {"lss-05"},
                  [is_answer](Middle&, Frame& frame) {
                    if (is_answer(frame, 0x5C)) frame.data[1] ^= 1U;
                    return true;
                  }),
      from_device("another node-ID by LSS than it has", {"lss-07"},
                  [is_answer](Middle& middle, Frame& frame) {
                    // Beside a command that configures it, whose cases ask for it as well.
                    const bool is_asked = is_answer(frame, 0x5E) && middle.count == 0;
                    if (is_asked) frame.data[1] ^= 1U;
                    if (is_answer(frame, 0x44)) middle.count = 0;
                    if (is_answer(frame, 0x11) || is_answer(frame, 0x13)) middle.count = 1;
                    return true;
                  }),
      from_device("node-ID 0 is taken", {"lss-09"},
                  [is_answer](Middle& middle, Frame& frame) {
                    if (is_answer(frame, 0x11) && middle.last_lss_request.data[1] == 0)
                      frame.data[1] = 0;
                    return true;
                  }),
      to_device("a command that there is not is answered", {"lss-14"},
                [is_request](Middle& middle, Frame& frame) {
                  if (is_request(frame, 0x7F)) {
                    middle.add(can_id::lss_response, {0x7F, 0, 0, 0, 0, 0, 0, 0});
                  }
                  return true;
                }),
      from_device("it is not found by its address", {"lss-17"},
                  [is_answer](Middle&, Frame& frame) { return !is_answer(frame, 0x4F); }),
      to_device("no SDO in configuration", {"lss-19"},
                [](Middle& middle, Frame& frame) {
                  return frame.id != middle.requests() || !middle.is_selected();
                }),
      to_device("no LSS in stopped", {"lss-20"},
                [](Middle& middle, Frame& frame) {
                  return frame.id != can_id::lss_request || middle.state() != NmtState::stopped;
                }),
  };
}

TEST(BrokenLss, IsFoundByTheCasesThatAreAboutIt) {
  for (const Way& way : lss_ways()) expect_found_in_module(way);
}

}  // namespace
}  // namespace canvoy::conformance::broken_lss_test

namespace canvoy::conformance {

std::vector<Way> lss_ways() {
  return broken_lss_test::lss_ways();
}

}  // namespace canvoy::conformance
