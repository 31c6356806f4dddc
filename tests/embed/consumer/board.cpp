#include "board.hpp"

#include "canvoy/devices/cia419/charger_device.hpp"

#if defined(__cpp_exceptions) || defined(__cpp_rtti)
#error "a board has neither exceptions nor RTTI"
#endif

namespace board {
namespace {

bool keep_frame(void* context, const canvoy::Frame& frame) {
  *static_cast<canvoy::Frame*>(context) = frame;
  return true;
}

}  // namespace

canvoy::Frame boot_up() {
  canvoy::Frame sent;
  canvoy::cia419::ChargerDevice charger({.context = &sent, .send = keep_frame}, 5, {});
  charger.node().start({});
  return sent;
}

}  // namespace board
