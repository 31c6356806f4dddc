// An input and output module of CiA 401 on a cable. The test sets its contacts and voltages, and
// checks its outputs and its frames.
//
//     struct Module : IoBench<default_io> {};
//     TEST_F(Module, AnInputThatChangesIsTold) { switch_contacts(0x05); }
#pragma once

#include <gtest/gtest.h>

#include <array>
#include <string>

#include "canvoy/canopen/testing/cable.hpp"
#include "canvoy/devices/cia401/io_device.hpp"

namespace canvoy::cia401 {

struct IoBoard {
  std::array<std::uint8_t, 18> contacts{};
  std::array<std::uint8_t, 8> valves{};
  std::array<std::int32_t, 12> volts{};
  std::array<std::int32_t, 12> driven{};

  std::uint8_t contact(unsigned group) { return contacts.at(group - 1); }
  void valve(unsigned group, std::uint8_t outputs) { valves.at(group - 1) = outputs; }
  std::int32_t volt(unsigned channel) { return volts.at(channel - 1); }
  void drive(unsigned channel, std::int32_t value) { driven.at(channel - 1) = value; }
  IoHardware hardware() {
    return {.digital_inputs = callback<&IoBoard::contact>(*this),
            .drive_digital = callback<&IoBoard::valve>(*this),
            .analogue_input = callback<&IoBoard::volt>(*this),
            .drive_analogue = callback<&IoBoard::drive>(*this)};
  }
  void set_volts(unsigned channel, std::int16_t value) {
    volts.at(channel - 1) = static_cast<std::int32_t>(static_cast<std::uint32_t>(value) << 16);
  }
};

template <IoOptions options>
class IoBench : public testing::Test {
 protected:
  IoBench() {
    cable.connect(0, device.node());
    cable.start_all();
    cable.send("000#01 21");
    cable.run_for(10ms);
    cable.clear();
  }
  void change() {
    device.unit().hardware_changed();
    cable.run_for(0s);
  }
  /// Sets 8 contacts from the first on.
  void switch_contacts(std::uint8_t states) {
    board.contacts[0] = states;
    change();
  }
  void turn(std::int16_t value) {
    board.set_volts(1, value);
    change();
  }
  /// The answer of the SDO server, from the command on.
  std::string ask(std::string_view request) {
    cable.send("621#" + std::string(request));
    return cable.last(0x5A1).substr(4);
  }
  void write(std::string_view request) { ASSERT_EQ(ask(request).substr(0, 2), "60") << request; }

  IoBoard board;
  Cable cable;
  IoDevice<options> device{
      cable.port(0), 33, board.hardware(), {.sensing_period = Duration::zero()}};
};

}  // namespace canvoy::cia401
