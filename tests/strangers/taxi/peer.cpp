// A shift of a simulated taxi in which devices are real, on a bus that is a pair of pipes:
//
//     canvoy_taxi_peer 2400 3                    # for so many seconds; node 3 is not played
//     canvoy_taxi_peer 2400 3:vendor=752 6       # node 3 has that vendor-ID, node 6 is anybody
//
//     703#05         a frame, each way
//     until 1500     time goes on to 1500 ms after the start, or to the next frame or event: now
//     1480 driver hiring  what the driver does from then on end            answers what is broken,
//     and what each trip came to
#include <cstdio>
#include <cstdlib>
#include <iostream>
#include <iterator>
#include <string>
#include <string_view>
#include <vector>

#include "canvoy/can/frame_text.hpp"
#include "canvoy/worlds/taxi/taxi_network.hpp"
#include "tests/strangers/pipe_node.hpp"

namespace canvoy {
namespace {

constexpr std::string_view activities[] = {
    "off_duty",  "calibrating",   "signing_on", "waiting",   "fetching",   "unmet",
    "boarding",  "hiring",        "carrying",   "at_lights", "stopping",   "paying",
    "releasing", "going_to_rest", "resting",    "rising",    "signing_off"};
static_assert(std::size(activities) == static_cast<std::size_t>(taxi::Activity::signing_off) + 1);

taxi::TaxiOptions options_of(int count, char** arguments) {
  taxi::TaxiOptions options;
  options.length = std::chrono::seconds(std::atoi(arguments[1]));
  options.shift.waiting_max = 1min;
  options.shift.trip_max_metres = 2000;
  for (int i = 2; i < count; ++i) {
    const std::string_view real = arguments[i];
    const auto id = static_cast<NodeId>(std::atoi(arguments[i]));
    options.real.push_back(id);
    constexpr std::string_view vendor = ":vendor=";
    const std::size_t at = real.find(vendor);
    if (at == std::string_view::npos) continue;
    car::RealIdentity identity{.id = id};
    identity.identity.address.parts[LssAddress::vendor] =
        static_cast<std::uint32_t>(std::atol(arguments[i] + at + vendor.size()));
    identity.identity.known[LssAddress::vendor] = true;
    options.identities.push_back(identity);
  }
  return options;
}

/// All that is on the bus goes out, and what comes in is sent there.
class Wire {
 public:
  explicit Wire(World& world) : port_(world.port(slot_of(world))) {
    world.occupy(slot_, *this);
    world.start(slot_);
  }

  void send(const Frame& frame) {
    if (!port_.send(port_.context, frame)) waiting_.push_back(frame);
  }
  bool take_heard() { return std::exchange(has_heard_, false); }
  SlotIndex slot() const { return slot_; }

  // As World wants a node to be.
  void start(Time) {}
  void receive(const Frame& frame, Time) {
    print_frame(nullptr, frame);
    has_heard_ = true;
  }
  void advance(Time) {}
  Time deadline() const { return never; }
  void bus_state(BusState, Time) {}
  void tx_ready(Time) {
    while (!waiting_.empty() && port_.send(port_.context, waiting_.front())) {
      waiting_.erase(waiting_.begin());
    }
  }
  void overrun(Time) {}

 private:
  SlotIndex slot_of(World& world) { return slot_ = world.add_slot(0, {.accept_all = true}); }

  SlotIndex slot_ = 0;
  Port port_;
  std::vector<Frame> waiting_;
  bool has_heard_ = false;
};

class Shift {
 public:
  explicit Shift(taxi::TaxiOptions options)
      : network_(std::move(options)), wire_(network_.world()) {}

  void run() {
    std::string line;
    while (std::getline(std::cin, line)) obey(line);
  }

 private:
  void obey(const std::string& line) {
    if (line.starts_with("until ")) return go_on(Time(1ms * std::atol(line.c_str() + 6)));
    if (line == "end") return end();
    if (const ParsedFrame parsed = parse_frame(line); parsed) wire_.send(parsed.frame);
    network_.world().touched(wire_.slot());
  }

  void go_on(Time until) {
    bool has_event = false;
    while (network_.now() < until && !has_event) {
      network_.run_until(network_.now() + 1ms);
      const auto driver = static_cast<std::size_t>(network_.snapshot().driver);
      has_event = wire_.take_heard() || driver != driver_;
      if (driver != driver_) print_line("driver " + std::string(activities[driver]));
      driver_ = driver;
    }
    print_line("now " + std::to_string((network_.now() - Time{}) / 1ms));
  }

  void end() {
    for (const taxi::Trip& trip : network_.trips()) {
      print_line("trip " + std::to_string(trip.paid / taxi::money_unit) + " " +
                 std::to_string(trip.metres));
    }
    for (const taxi::Invariant& invariant : network_.invariants()) {
      const std::string name(invariant_name(invariant.kind).name);
      if (!invariant.held) print_line("broken " + name);
      if (!invariant.is_decided()) print_line("undecided " + name);
    }
    print_line("end");
  }

  taxi::TaxiNetwork network_;
  Wire wire_;
  std::size_t driver_ = 0;
};

}  // namespace
}  // namespace canvoy

int main(int count, char** arguments) {
  if (count < 3) return 2;
  canvoy::Shift(canvoy::options_of(count, arguments)).run();
}
