// Ends with 0 if a node of one's own boots and answers: what a source folder is embedded for.
#include <iostream>

#include "node.hpp"

namespace {

bool keep_frame(void* context, const canvoy::Frame& frame) {
  *static_cast<canvoy::Frame*>(context) = frame;
  return true;
}

}  // namespace

int main() {
  canvoy::Frame sent;
  canvoy::DeviceNode<my_charger::layout> device({.context = &sent, .send = keep_frame}, 5);
  device.node().start({});
  // CiA 301, 7.2.8.3.3: the boot-up message is a byte 0 under 700h and the node-ID.
  if (sent != canvoy::Frame::data_frame(0x705, {0})) return 1;
  // CiA 301, 7.2.4.3.5 and 7.2.4.3.6: an expedited upload of 1000h; CiA 419, 6.2.1: 419 is 1A3h.
  device.node().receive(canvoy::Frame::data_frame(0x605, {0x40, 0x00, 0x10, 0, 0, 0, 0, 0}), {});
  if (sent != canvoy::Frame::data_frame(0x585, {0x43, 0x00, 0x10, 0, 0xA3, 0x01, 0, 0})) return 1;
  std::cout << "a node boots and answers\n";
}
