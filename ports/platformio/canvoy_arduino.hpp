// A board with the Arduino framework. The application supplies the CAN library, as two functions.
//
//     ArduinoCan can(send, receive);     // bool send(const Frame&), bool receive(Frame&)
//     BoardPort port(can);
//     void loop() { port.turn(device.node()); }
#pragma once

#include <Arduino.h>

#include "canvoy_board.hpp"

namespace canvoy::board {

class ArduinoCan {
 public:
  ArduinoCan(bool (*sender)(const Frame&), bool (*receiver)(Frame&))
      : send_(sender), receive_(receiver) {}

  bool send(const Frame& frame) { return send_(frame); }
  bool receive(Frame& frame) { return receive_(frame); }

  /// Time since the start. micros() has 32 bits and overflows after 71 minutes: this extends it if
  /// it is called at least once in that time, as turn() does.
  Time now() {
    const auto micros_now = static_cast<std::uint32_t>(micros());
    micros_ += static_cast<std::uint32_t>(micros_now - last_);
    last_ = micros_now;
    return Time(Duration(micros_));
  }

 private:
  bool (*send_)(const Frame&);
  bool (*receive_)(Frame&);
  std::int64_t micros_ = 0;
  std::uint32_t last_ = 0;
};

}  // namespace canvoy::board
