// Simulated devices of a script, and hands on them: lines `device`, `set` and `press`. Each device
// is a `canvoy device` of its own, which takes its hands from its standard input, and ends with the
// script.
//
//     ScriptDevices devices;
//     const auto begin = devices.parse({"device", "battery", "--node-id", "10"}, "can0");
//     const auto warm = devices.parse({"set", "temperature=60"}, "can0");
//     begin();
//     warm();
#pragma once

#include <sys/types.h>

#include <deque>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace canvoy::tools {

class ScriptDevices {
 public:
  ScriptDevices() = default;
  ~ScriptDevices();
  ScriptDevices(const ScriptDevices&) = delete;
  ScriptDevices& operator=(const ScriptDevices&) = delete;

  static bool has_verb(std::string_view verb) {
    return verb == "device" || verb == "set" || verb == "press";
  }
  /// What the line does, later. Throws UsageError, in the words of `canvoy device`, for a device
  /// that there is none of, or a hand or value that no device of the lines before has. Costs some
  /// milliseconds for each of these devices, which are asked. What it returns throws Failure if the
  /// device has ended.
  std::function<void()> parse(const std::vector<std::string>& words, const std::string& bus);

 private:
  struct Device {
    std::vector<std::string> words;  ///< kinds and options, without the bus
    std::string bus;
    pid_t process = 0;
    int orders = -1;  ///< its standard input
  };

  std::function<void()> parse_hand(const std::vector<std::string>& words);
  static void start(Device& device);
  static void send(Device& device, const std::string& order);

  std::deque<Device> devices_;
};

}  // namespace canvoy::tools
