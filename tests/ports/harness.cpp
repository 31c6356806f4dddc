// Runs the sample of a port (PORT_ZEPHYR, PORT_FREERTOS, PORT_ESP_IDF or PORT_PLATFORMIO) on the
// bus of the stubs, which ends it.
#include "canvoy/can/frame.hpp"
#include "fake_bus.hpp"

namespace {

[[maybe_unused]] bool take(canvoy::Frame& frame) {
  const fake::Message* message = fake::take();
  if (message == nullptr) return false;
  frame = canvoy::Frame::data_frame(message->id, {message->data, message->length});
  return true;
}

}  // namespace

#if defined(PORT_ZEPHYR)
int sample_main();
int main() {
  return sample_main();
}
#elif defined(PORT_FREERTOS)
void pump_task(void*);
void can_received(const canvoy::Frame& frame);
bool can_transmit(const canvoy::Frame& frame) {
  return fake::transmit(frame.id, frame.length, frame.data.data());
}
void fake_interrupt() {
  for (canvoy::Frame frame; take(frame);) can_received(frame);
}
int main() {
  pump_task(nullptr);
}
#elif defined(PORT_ESP_IDF)
extern "C" void app_main();
int main() {
  app_main();
}
#elif defined(PORT_PLATFORMIO)
void setup();
void loop();
bool can_send(const canvoy::Frame& frame) {
  return fake::transmit(frame.id, frame.length, frame.data.data());
}
bool can_receive(canvoy::Frame& frame) {
  return take(frame);
}
int main() {
  setup();
  for (;;) {
    loop();
    fake::wait(1000);
  }
}
#endif
