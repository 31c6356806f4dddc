// Faults that a drive detects itself: faults of CiA 402, each reported by an emergency until a
// fault reset.
//
//     DriveFaults faults(node);
//     if (faults.add(DriveFault::overspeed)) ...  // it is a new one: FF05h has been told
//     faults.end_all();                           // and is gone
#pragma once

#include <cstdint>

#include "canvoy/canopen/node/node.hpp"
#include "canvoy/profiles/cia417/errors.hpp"

namespace canvoy::cia417 {

/// A fault that the drive itself detects.
enum class DriveFault : std::uint8_t {
  overspeed,   ///< FF05h
  unintended,  ///< the car moves when it has to stand: FF06h
  following,   ///< it is too far from its demanded position: 8611h (CiA 402)
  hardware,    ///< with the code of the hardware
  brake,       ///< it slips at its self-test: 7000h (CiA 301, additional modules)
};
/// For loops.
inline constexpr DriveFault all_drive_faults[] = {DriveFault::overspeed, DriveFault::unintended,
                                                  DriveFault::following, DriveFault::hardware,
                                                  DriveFault::brake};

/// True for overspeed or unintended car movement.
constexpr bool is_dangerous_motion(std::uint16_t code) {
  return code == emergency_code::overspeed || code == emergency_code::unintended_car_movement;
}

class DriveFaults {
 public:
  /// Makes a state without faults; `node` must outlive it, and reports them.
  explicit DriveFaults(Node& node) : node_(node) {}
  DriveFaults(const DriveFaults&) = delete;
  DriveFaults& operator=(const DriveFaults&) = delete;

  /// True while a fault holds.
  bool has(DriveFault fault) const { return (present_ & bit(fault)) != 0; }
  /// True if one of them is overspeed or unintended movement.
  bool has_dangerous_motion() const {
    return has(DriveFault::overspeed) || has(DriveFault::unintended);
  }
  /// False if it exists already. `code` is that of the hardware's fault.
  bool add(DriveFault fault, std::uint16_t code = 0);
  /// Ends all faults, and reports that: a fault reset.
  void end_all();
  /// Clears all faults: the node has restarted, without errors.
  void begin_anew() { present_ = 0; }

 private:
  static constexpr std::uint8_t bit(DriveFault fault) {
    return static_cast<std::uint8_t>(1U << static_cast<unsigned>(fault));
  }
  Error error_of(DriveFault fault) const;

  Node& node_;
  std::uint16_t hardware_code_ = 0;
  std::uint8_t present_ = 0;
};

}  // namespace canvoy::cia417
