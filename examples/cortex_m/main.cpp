// A node with an object of its own on a Cortex-M0, from its reset on: it boots, answers a request,
// and sends heartbeats. What it sends is printed by semihosting, the debugger's console, which QEMU
// has as well. A CAN controller is not there: the board is the three functions of ports/common, one
// of which receives the request.
#include <cstddef>
#include <cstdint>
#include <cstring>

#include "canvoy_board.hpp"
#include "pump.hpp"

// The linker script says where they lie.
extern "C" {
extern std::uint32_t stack_top[], data_from[], data_begin[], data_end[], bss_begin[], bss_end[];
}

namespace {

enum Semihosting : int { write_text = 0x04, end_program = 0x18 };
constexpr std::uintptr_t ended_well = 0x20026;  // ADP_Stopped_ApplicationExit

void ask_debugger(Semihosting operation, std::uintptr_t argument) {
  asm volatile("mov r0, %0\n mov r1, %1\n bkpt 0xAB"
               :
               : "r"(operation), "r"(argument)
               : "r0", "r1", "memory");
}

char hexadecimal(unsigned digit) {
  return "0123456789ABCDEF"[digit & 0xF];
}

/// Virtual time, so that a run is the same each time; one request, an SDO upload of 2000h (CiA
/// 301, 7.2.4.3.5).
class Board {
 public:
  bool send(const canvoy::Frame& frame) {
    char text[32];
    char* end = text;
    for (int shift = 8; shift >= 0; shift -= 4) *end++ = hexadecimal(frame.id >> shift);
    *end++ = '#';
    for (std::size_t i = 0; i < frame.length; ++i) {
      *end++ = hexadecimal(frame.data[i] >> 4);
      *end++ = hexadecimal(frame.data[i]);
    }
    *end++ = '\n';
    *end = '\0';
    ask_debugger(write_text, reinterpret_cast<std::uintptr_t>(text));
    return true;
  }
  bool receive(canvoy::Frame& frame) {
    if (is_asked_ || now_ == canvoy::Time()) return false;
    is_asked_ = true;
    frame = canvoy::Frame::data_frame(0x609, {0x40, 0x00, 0x20, 0x00, 0, 0, 0, 0});
    return true;
  }
  canvoy::Time now() { return now_; }
  void wait(canvoy::Duration longest) { now_ += longest; }

 private:
  canvoy::Time now_{};
  bool is_asked_ = false;
};

void run() {
  static Board board;
  static canvoy::board::BoardPort port(board);
  static pump::Device device(port.port(), 9);
  device.node().start(board.now());
  constexpr canvoy::Time end = canvoy::Time() + std::chrono::milliseconds(2500);
  while (board.now() < end) board.wait(port.turn(device.node(), std::chrono::milliseconds(100)));
  ask_debugger(end_program, ended_well);
}

}  // namespace

extern "C" {
[[noreturn]] void reset() {
  std::memcpy(data_begin, data_from,
              static_cast<std::size_t>(data_end - data_begin) * sizeof(std::uint32_t));
  std::memset(bss_begin, 0, static_cast<std::size_t>(bss_end - bss_begin) * sizeof(std::uint32_t));
  run();
  for (;;) asm volatile("");
}

[[noreturn]] void fault() {
  ask_debugger(write_text, reinterpret_cast<std::uintptr_t>("fault\n"));
  ask_debugger(end_program, 0x20023);  // ADP_Stopped_RunTimeErrorUnknown
  for (;;) asm volatile("");
}

[[gnu::section(".vectors"), gnu::used]] const std::uintptr_t vectors[4] = {
    reinterpret_cast<std::uintptr_t>(stack_top), reinterpret_cast<std::uintptr_t>(reset),
    reinterpret_cast<std::uintptr_t>(fault), reinterpret_cast<std::uintptr_t>(fault)};
}
