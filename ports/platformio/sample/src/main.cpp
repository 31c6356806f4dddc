// A pump with one application object, for the Arduino framework. Supply can_send() and
// can_receive() from the CAN library of your board.
#include "canvoy_arduino.hpp"
#include "pump.hpp"

/// Function of your CAN library: false if the controller has no room.
bool can_send(const canvoy::Frame& frame);
/// Function of your CAN library: false if no frame has arrived.
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
