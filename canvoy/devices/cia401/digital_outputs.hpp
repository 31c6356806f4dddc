// The digital outputs of CiA 401: polarity, filter mask, and what they do when the device fails
// (6200h to 6208h, 6300h to 6308h, 6320h to 6328h).
//
//     DigitalOutputs outputs(node, memory, {.drive = ...});
//     outputs.fail();    // a heartbeat is lost
//
// The text of CiA 401 is not at hand. Our reading: an output that the filter mask leaves out keeps
// its state, and objects say what the outputs are, before their polarity, by whichever width they
// were written. After a failure they stay until somebody writes them.
#pragma once

#include <cstdint>
#include <span>

#include "canvoy/canopen/node.hpp"
#include "canvoy/profiles/cia401/handles.hpp"

namespace canvoy::cia401 {

class DigitalOutputs {
 public:
  /// 8 outputs as they are wired: the group counts from 1, the first output is bit 0.
  using Drive = Callback<void(unsigned group, std::uint8_t outputs)>;

  /// All must outlive this. `groups`: one byte for each element of 6200h, which has no gaps.
  DigitalOutputs(Node& node, std::span<std::uint8_t> groups, Drive drive)
      : node_(node), groups_(groups), drive_(drive) {}
  DigitalOutputs(const DigitalOutputs&) = delete;
  DigitalOutputs& operator=(const DigitalOutputs&) = delete;

  /// Drives what the objects say: after a reset.
  void begin();
  /// An element of this object was written by the bus; of another one, nothing happens.
  void written(std::uint16_t index, std::uint8_t sub);
  /// Outputs with error mode 1 take their error value.
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
