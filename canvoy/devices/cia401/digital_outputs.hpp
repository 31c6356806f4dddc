// The digital outputs of CiA 401: polarity, filter mask, and their reaction when the device fails
// (6200h to 6208h, 6300h to 6308h, 6320h to 6328h).
//
//     DigitalOutputs outputs(node, memory, {.drive = ...});
//     outputs.fail();    // a heartbeat is lost
//
// The text of CiA 401 is not at hand. Our reading: an output that the filter mask leaves out keeps
// its state. Objects show the outputs before their polarity, whatever the width in which they were
// written. After a failure the outputs stay until they are written.
#pragma once

#include <cstdint>
#include <span>

#include "canvoy/canopen/node/node.hpp"
#include "canvoy/profiles/cia401/handles.hpp"

namespace canvoy::cia401 {

class DigitalOutputs {
 public:
  /// Drives 8 outputs as wired: the group counts from 1, the first output is bit 0.
  using Drive = Callback<void(unsigned group, std::uint8_t outputs)>;

  /// All arguments must outlive this. `groups`: one byte for each element of 6200h, which has no
  /// gaps.
  DigitalOutputs(Node& node, std::span<std::uint8_t> groups, Drive drive)
      : node_(node), groups_(groups), drive_(drive) {}
  DigitalOutputs(const DigitalOutputs&) = delete;
  DigitalOutputs& operator=(const DigitalOutputs&) = delete;

  /// Drives the values of the objects: after a reset.
  void begin();
  /// Drives an element of this object that the bus has written. Without effect for other objects.
  void written(std::uint16_t index, std::uint8_t sub);
  /// Sets outputs with error mode 1 to their error value.
  void fail();

 private:
  void change(std::size_t group, std::uint32_t value, std::uint32_t which);
  void show(std::size_t first, std::size_t end);
  void drive(std::size_t group);

  Node& node_;
  std::span<std::uint8_t> groups_;
  Drive drive_;
};

}  // namespace canvoy::cia401
