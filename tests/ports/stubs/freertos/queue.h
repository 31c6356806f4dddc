// Queues of FreeRTOS, whose driver is the script of the bus.
#pragma once

struct StaticQueue_t {
  std::uint8_t* storage;
  unsigned item_size, length, count;
};
using QueueHandle_t = StaticQueue_t*;

inline QueueHandle_t xQueueCreateStatic(unsigned length, unsigned item_size, std::uint8_t* storage, StaticQueue_t* control) {
  *control = {storage, item_size, length, 0};
  return control;
}
inline BaseType_t xQueueSendFromISR(QueueHandle_t queue, const void* item, BaseType_t* woken) {
  *woken = pdTRUE;
  if (queue->count == queue->length) return pdFALSE;
  std::memcpy(queue->storage + queue->item_size * queue->count++, item, queue->item_size);
  return pdTRUE;
}
inline BaseType_t xQueueReceive(QueueHandle_t queue, void* item, TickType_t) {
  if (queue->count == 0) return pdFALSE;
  std::memcpy(item, queue->storage, queue->item_size);
  --queue->count;
  std::memmove(queue->storage, queue->storage + queue->item_size, queue->item_size * queue->count);
  return pdTRUE;
}
void fake_interrupt();  // the harness's: the driver hands over what has come
inline BaseType_t xQueuePeek(QueueHandle_t queue, void*, TickType_t ticks) {
  fake::wait(std::int64_t{ticks} * 1000);
  fake_interrupt();
  return queue->count == 0 ? pdFALSE : pdTRUE;
}
