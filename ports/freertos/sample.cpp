// A pump with one application object, in a task of FreeRTOS. Supply can_transmit() and have the
// driver call can_received().
#include "canvoy_freertos.hpp"
#include "pump.hpp"

/// Function of the driver: puts a frame into the controller; false if there is no room.
bool can_transmit(const canvoy::Frame& frame);

static canvoy::board::FreeRtosCan<> can(can_transmit);

/// For the driver's interrupt.
void can_received(const canvoy::Frame& frame) {
  can.received_from_isr(frame);
}

/// The task: xTaskCreate(pump_task, "pump", 1024, nullptr, 3, nullptr).
void pump_task(void*) {
  static canvoy::board::BoardPort board(can);
  static pump::Device device(board.port(), 9);
  device.node().start(can.now());
  for (;;) can.wait(board.turn(device.node()));
}
