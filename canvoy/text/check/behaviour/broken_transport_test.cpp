// Devices of cars, of buses and of the panels of a lift with a deliberate defect: each defect is
// found by the cases that concern it, and by no other.
#include "canvoy/text/check/testing/all_ways.hpp"
#include "canvoy/text/check/testing/broken_device.hpp"

namespace canvoy::conformance::broken_transport_test {
namespace {

constexpr std::uint32_t own_pdo = 0x6B3;  ///< CAN-ID that the test gives a PDO without one

/// True for a PDO of the device with this number of bytes.
bool is_tpdo(const Frame& frame, unsigned length) {
  const bool is_pdo = (frame.id > 0x180 && frame.id < 0x580) || frame.id == own_pdo;
  return is_pdo && frame.is_plain() && frame.length == length;
}
Way lost_tpdo(std::string_view name, std::string_view found_by, unsigned length) {
  return {name, {found_by}, [length](Middle&, Frame& frame) { return !is_tpdo(frame, length); }};
}
/// Clears bits of a byte of an upload.
Way cleared(std::string_view name, std::string_view found_by, std::uint16_t index, unsigned byte,
            std::uint8_t bits) {
  return {name, {found_by}, [index, byte, bits](Middle& middle, Frame& frame) {
            if (is_upload(middle, frame, index)) {
              frame.data[byte] = static_cast<std::uint8_t>(frame.data[byte] & ~bits);
            }
            return true;
          }};
}
/// Confirms a download of `sub` that was refused.
Way taken(std::string_view name, std::string_view found_by, std::uint16_t index,
          std::initializer_list<std::uint8_t> subs) {
  return {name, {found_by}, [index, subs = std::vector<std::uint8_t>(subs)](Middle&, Frame& frame) {
            const bool is_sub = std::ranges::find(subs, frame.data[3]) != subs.end();
            if (is_sub && is_abort(frame, index, AbortCode::value_range)) say_written(frame);
            return true;
          }};
}
/// Changes the value of a download.
Way changed(std::string_view name, std::vector<std::string_view> found_by, std::uint16_t index,
            std::uint32_t value, std::uint32_t becomes) {
  return {name, std::move(found_by), {}, [index, value, becomes](Middle& middle, Frame& frame) {
            if (is_download(middle, frame, index) && load<std::uint32_t>(&frame.data[4]) == value) {
              store(&frame.data[4], becomes);
            }
            return true;
          }};
}

std::vector<BrokenDevice> car_ways() {
  return {
      {"gps", cleared("reserved bits of its status are 0", "447-3-gps-03", 0x60B2, 7, 0xF0)},
      {"gps", cleared("reserved bits of its date are 0", "447-3-gps-04", 0x60B3, 7, 0xFC)},
      {"gps", from_device("it has a fix in two dimensions at most", {"447-3-gps-01"},
                          [](Middle& middle, Frame& frame) {
                            if (is_upload(middle, frame, 0x60B2) && (frame.data[7] & 0x0F) == 2)
                              --frame.data[7];
                            return true;
                          })},
      {"gps", lost_tpdo("it does not tell where it is", "447-3-gps-02", 8)},
      {"navigation", taken("it takes a reserved start", "447-3-navigation-05", 0x60C3, {3})},
      {"navigation",
       taken("it takes a destination that is nowhere", "447-3-navigation-06", 0x60C3, {1, 2})},
      {"navigation", taken("it describes what is nowhere", "447-3-navigation-07", 0x60C1, {1, 2})},
      {"navigation",
       changed("\"do not care\" starts guidance", {"447-3-navigation-04"}, 0x60C3, 0xFF, 0x01)},
      {"navigation", changed("it starts nothing without interrupting", {"447-3-navigation-03"},
                             0x60C3, 0x00, 0xFF)},
      {"driver-identification",
       cleared("reserved bits of its status are 0", "447-3-driver-05", 0x60FA, 4, 0xC0)},
      {"driver-identification",
       cleared("its data are never valid", "447-3-driver-03", 0x60FA, 4, 0x0C)},
      {"driver-identification",
       cleared("it says no identification failure", "447-3-driver-04", 0x60FA, 4, 0x30)},
      {"driver-identification", lost_tpdo("it does not tell who drives", "447-3-driver-02", 1)},
      {"roof-bar-sound", to_device("it takes no volume", {"447-3-sound-06"},
                                   [](Middle& middle, Frame& frame) {
                                     if (is_download(middle, frame, 0x613A) && frame.data[3] == 1)
                                       frame.data[7] |= 0x3F;
                                     return true;
                                   })},
      {"roof-bar-sound", changed("\"do not care\" turns it off", {"447-3-sound-05"}, 0x613A,
                                 0xFFFF'FFFF, 0xFFFF'FF00)},
      {"roof-bar-sound",
       taken("it takes a reserved sound of a country", "447-3-sound-02", 0x6138, {0})},
      {"roof-bar-sound",
       cleared("reserved bits of its status are 0", "447-3-sound-09", 0x613B, 5, 0xFF)},
      {"roof-bar-sound", lost_tpdo("it does not tell what it plays", "447-3-sound-10", 8)},
  };
}

std::vector<BrokenDevice> bus_ways() {
  return {
      {"ticket-canceller", changed("it is not blocked", {"407-canceller-02"}, 0x6116, 0x80, 0x00)},
      {"ticket-canceller",
       changed("it stays blocked", {"407-canceller-01", "407-canceller-03"}, 0x6116, 0x00, 0x80)},
      {"ticket-printer",
       from_device("it does not say that it has no paper", {"407-printer-02", "407-printer-03"},
                   [](Middle& middle, Frame& frame) {
                     return frame.id != middle.emergencies() || frame.data[1] != 0xFF;
                   })},
      {"ticket-printer", from_device("it does not say that it has paper again", {"407-printer-03"},
                                     [](Middle& middle, Frame& frame) {
                                       return frame.id != middle.emergencies() ||
                                              frame.data[1] != 0x00;
                                     })},
      {"passenger-counter",
       from_device("who comes in is who goes out", {"407-counter-01", "407-counter-04"},
                   [](Middle& middle, Frame& frame) {
                     if (is_upload(middle, frame, 0x6700)) std::swap(frame.data[4], frame.data[5]);
                     return true;
                   })},
      {"passenger-counter", lost_tpdo("it does not tell what it has counted", "407-counter-02", 2)},
      {"passenger-counting-manager",
       to_device("nobody goes out", {"407-counting-01", "407-counting-02"},
                 [](Middle& middle, Frame& frame) {
                   if (is_download(middle, frame, 0x6700)) frame.data[4] = 0;
                   return true;
                 })},
  };
}

/// True for a record by RPDO.
bool is_record(const Frame& frame) {
  return (frame.id == 0x400 || frame.id == own_pdo) && frame.length == 6;
}
/// Sets a byte of each record to that of lamp 1.
Way own_byte(std::string_view name, std::string_view found_by, unsigned byte, std::uint8_t value) {
  return {name, {found_by}, {}, [byte, value](Middle&, Frame& frame) {
            if (is_record(frame)) frame.data[byte] = value;
            return true;
          }};
}
/// Changes controlwords of four doors.
Way controlword(std::string_view name, std::string_view found_by, void (*change)(Frame&)) {
  return {name, {found_by}, [change](Middle&, Frame& frame) {
            if (is_tpdo(frame, 8)) change(frame);
            return true;
          }};
}

std::vector<BrokenDevice> lift_ways() {
  return {
      {"lift-input-panel", changed("a button that is disabled is told", {"417-4-button-03"}, 0x6120,
                                   0xFFFF'FFFE, 0xFFFF'FFFF)},
      {"lift-input-panel", changed("it does not know one edge from the other", {"417-4-button-04"},
                                   0x6160, 0xFFFF'7DFF, 0xFFFF'7FFF)},
      {"lift-input-panel", changed("nor the other from the one", {"417-4-button-05"}, 0x6160,
                                   0xFFFF'7EFF, 0xFFFF'7FFF)},
      {"lift-input-panel", from_device("it tells another floor",
                                       {"417-4-button-01", "417-4-button-04", "417-4-button-05"},
                                       [](Middle&, Frame& frame) {
                                         if (is_tpdo(frame, 6)) frame.data[3] ^= 0x40U;
                                         return true;
                                       })},
      {"lift-output-panel", own_byte("it takes records for other lifts", "417-4-lamp-03", 2, 0x01)},
      {"lift-output-panel",
       own_byte("it takes records for other floors", "417-4-lamp-04", 3, 0x01)},
      {"lift-output-panel",
       own_byte("it takes records of other functions", "417-4-lamp-05", 0, 0x02)},
      {"lift-output-panel", changed("a lamp that is disabled is lit", {"417-4-lamp-06"}, 0x6220,
                                    0xFFFF'FFFE, 0xFFFF'FFFF)},
      {"lift-door-controller", controlword("it opens door 2 as well", "417-4-door-controller-04",
                                           [](Frame& frame) { frame.data[3] = frame.data[1]; })},
      {"lift-door-controller",
       controlword("reserved bits of its controlword are 0", "417-4-door-controller-05",
                   [](Frame& frame) { frame.data[0] &= 0xFC; })},
      {"lift-door-controller", controlword("it does not stop a door", "417-4-door-controller-03",
                                           [](Frame& frame) {
                                             if (frame.data[1] >> 4 == 8) frame.data[1] = 0xFF;
                                           })},
  };
}

TEST(BrokenTransport, IsFoundInCars) {
  for (const BrokenDevice& broken : car_ways()) expect_found(broken);
}
TEST(BrokenTransport, IsFoundInBuses) {
  for (const BrokenDevice& broken : bus_ways()) expect_found(broken);
}
TEST(BrokenTransport, IsFoundInLifts) {
  for (const BrokenDevice& broken : lift_ways()) expect_found(broken);
}

}  // namespace
}  // namespace canvoy::conformance::broken_transport_test

namespace canvoy::conformance {

std::vector<BrokenDevice> transport_ways() {
  using namespace broken_transport_test;  // NOLINT(google-build-using-namespace): its tables
  std::vector<BrokenDevice> all = car_ways();
  for (auto&& ways : {bus_ways(), lift_ways()}) all.insert(all.end(), ways.begin(), ways.end());
  return all;
}

}  // namespace canvoy::conformance
