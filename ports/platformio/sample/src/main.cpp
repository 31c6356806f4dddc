// A pump with an object of its own, for the Arduino framework. Bring can_send() and can_receive()
// of the CAN library of your board.
#include "canvoy_arduino.hpp"
#include "pump.hpp"

/// Of your CAN library: false where the controller has no room.
bool can_send(const canvoy::Frame& frame);
/// Of your CAN library: false where no frame has come.
bool can_receive(canvoy::Frame& frame);

static canvoy::board::ArduinoCan can(can_send, can_receive);
static canvoy::board::BoardPort board(can);
static pump::Device device(board.port(), 9);

void setup() {
  device.node().start(can.now());
}

void loop() {
  board.turn(device.node());
}
