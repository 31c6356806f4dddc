// Ends with 0 if the library does what it says: a charger boots, and charges a battery in a
// simulated world.
#include <iostream>

#include "board.hpp"
#include "canvoy/version.hpp"
#include "canvoy/worlds/charger/charger_network.hpp"

int main() {
  // CiA 301, 7.2.8.3.3: the boot-up message is a byte 0 under 700h and the node-ID.
  if (board::boot_up() != canvoy::Frame::data_frame(0x705, {0})) {
    std::cout << "the charger did not boot\n";
    return 1;
  }
  canvoy::charger::ChargerNetwork network;
  network.run_until(canvoy::Time(std::chrono::minutes(1)));
  std::cout << "canvoy " << canvoy::version << ": a minute of charging\n";
  for (const canvoy::charger::Invariant& invariant : network.invariants()) {
    if (!invariant.held) return 1;
  }
}
