// A pump with one application object, on an ESP32 with a CAN transceiver at GPIO 21 and 22.
#include "canvoy_esp_idf.hpp"
#include "pump.hpp"

extern "C" void app_main() {
  static canvoy::board::EspCan can;
  if (!can.start(GPIO_NUM_21, GPIO_NUM_22, TWAI_TIMING_CONFIG_125KBITS())) return;
  static canvoy::board::BoardPort board(can);
  static pump::Device device(board.port(), 9);
  device.node().start(can.now());
  for (;;) can.wait(board.turn(device.node()));
}
