// A pump with one application object, on the CAN controller that the board's devicetree selects.
#include "canvoy_zephyr.hpp"
#include "pump.hpp"

int main() {
  static canvoy::board::ZephyrCan can(DEVICE_DT_GET(DT_CHOSEN(zephyr_canbus)));
  if (!can.start(125'000)) return -1;
  static canvoy::board::BoardPort board(can);
  static pump::Device device(board.port(), 9);
  device.node().start(can.now());
  for (;;) can.wait(board.turn(device.node()));
}
