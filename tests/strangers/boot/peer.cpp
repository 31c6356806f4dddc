// An NMT master for strangers to be booted by, on a bus that is a pair of pipes (pipe_node.hpp).
//
// What it reports: `report NODE EVENT STEP LETTER EXPECTED FOUND`, numbers in hexadecimal, events
// and steps as BootEvent and BootStep count them.
#include <cstdio>

#include "canvoy/canopen/manager/master_node.hpp"
#include "tests/strangers/pipe_node.hpp"

namespace {

using namespace canvoy;

constexpr EntryRow slaves(DataType type) {
  return {.sub_first = 1, .sub_last = 127, .type = type, .access = Access::rw};
}
constexpr EntryRow number(DataType type, std::int64_t initial) {
  return {.type = type, .access = Access::rw, .initial = initial};
}

constexpr auto layout = partial(lay_out(
    std::to_array<ObjectRow>({{.index = 0x1000, .entry_count = 1},
                              {.index = 0x1001, .entry_count = 1},
                              {.index = 0x1F80, .entry_count = 1},
                              {.index = 0x1F81, .entry_count = 2},
                              {.index = 0x1F84, .count = 5, .entry_count = 2}}),
    std::to_array<EntryRow>({number(DataType::unsigned32, 0), number(DataType::unsigned8, 0),
                             number(DataType::unsigned32, 0x01), number(DataType::unsigned8, 127),
                             slaves(DataType::unsigned32), number(DataType::unsigned8, 127),
                             slaves(DataType::unsigned32)})));

/// Slaves 10, 11 and 12, of which all are expected to be of vendor 123h.
class Peer {
 public:
  Peer() {
    stored_.reset = Callback<void(ResetScope)>::to<&Peer::restore>(*this);
    master_.node().attach(stored_);
    master_.boot_manager().on_report(Callback<void(const BootReport&)>::to<&Peer::told>(*this));
  }

  Node& node() { return master_.node(); }

 private:
  void restore(ResetScope) {
    Dictionary& dictionary = master_.dictionary();
    for (std::uint8_t slave = 10; slave <= 12; ++slave) {
      dictionary.set_number(0x1F81, slave, 0x05);
      dictionary.set_number(0x1F84, slave, 0x000F'0191);
      dictionary.set_number(0x1F85, slave, 0x123);
      dictionary.set_number(0x1F88, slave, 0xDEAD'BE00U + slave);
    }
  }
  void told(const BootReport& report) {
    char text[64];
    std::snprintf(text, sizeof text, "report %u %u %u %c %X %X", report.slave,
                  static_cast<unsigned>(report.event), static_cast<unsigned>(report.step),
                  letter(report.outcome.error), report.expected, report.found);
    print_line(text);
  }

  Service stored_;
  MasterNode<layout> master_{pipe_port, 127};
};

}  // namespace

int main() {
  canvoy::PipeNode<Peer>().run();
}
