// Simulated devices of a script, and hands on them: lines `device`, `set` and `press`. Each device
// is a `canvoy device` of its own, which takes its hands from its standard input, and ends with the
// script.
//
//     ScriptDevices devices;
//     const auto begin = devices.parse({"device", "battery", "--node-id", "10"}, "can0", session);
//     const auto warm = devices.parse({"set", "temperature=60"}, "can0", session);
//     begin();
//     warm();
#pragma once

#include <sys/types.h>

#include <deque>
#include <functional>
#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

#include "canvoy/tools/session/session.hpp"

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
  /// Opens the bus of the line.
  using OpensSession = std::function<Session&()>;

  /// What the line does, later. Throws UsageError, in the words of `canvoy device`, for a device
  /// that there is none of, or a hand or value that no device of the lines before has. Costs some
  /// milliseconds for each of these devices, which are asked. What it returns waits until a device
  /// is there, 5 s at most, and throws Failure if the device of a hand has ended.
  std::function<void()> parse(const std::vector<std::string>& words, const std::string& bus,
                              OpensSession session);

 private:
  struct Device {
    std::vector<std::string> kinds;
    std::vector<std::string> options;
    std::string bus;
    pid_t process = 0;
    int orders = -1;  ///< its standard input

    /// What `canvoy device` is told.
    std::vector<std::string> words(const std::string& on_bus,
                                   std::initializer_list<std::string> further) const;
  };

  std::function<void()> parse_hand(const std::vector<std::string>& words);
  static void start(Device& device);
  /// Starts it, and waits until its nodes have booted, or answer that they wait for a node-ID: the
  /// next line finds them there.
  static void start(Device& device, Session& session);
  static void send(Device& device, const std::string& order);

  std::deque<Device> devices_;
};

}  // namespace canvoy::tools
