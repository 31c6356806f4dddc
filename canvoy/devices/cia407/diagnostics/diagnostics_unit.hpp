// The diagnostics device: collects reports of other devices (CiA 407, 6.23, 9.2.27): short errors
// (6740h), the newest first; messages of three classes (6742h to 6744h), in the order of arrival;
// and a file with a line for each of them (6741h). They outlive NMT resets.
//
//     DiagnosticsUnit diagnostics(device, {}, {});
//     diagnostics.report(0x0012, 0x3120);                   // from an error input
//     diagnostics.report(ErrorClass::second, "door 2 is stiff");
//
// Other devices write to sub-index 01h. A full history of short errors drops the oldest; a full
// class accepts no more; a full file drops its oldest lines. A reader gets the file as it was at
// the start of reading, whole, without lines that are added meanwhile. If lines that are not yet
// read are dropped, or the file is erased, the reader gets 0800 0022h, and may start again.
#pragma once

#include <array>
#include <string_view>

#include "canvoy/devices/cia407/kit/bus_kind.hpp"
#include "canvoy/devices/cia407/kit/bus_time.hpp"
#include "canvoy/profiles/cia407/devices.hpp"

namespace canvoy::cia407 {

/// Class of a message: 6742h, 6743h or 6744h.
enum class ErrorClass : std::uint8_t { first, second, third };

/// Limit of the list of errors.
struct DiagnosticsSettings {
  unsigned close_to_limit = 240;  ///< entries of 6740h, of 254
};

class DiagnosticsUnit {
 public:
  static constexpr std::size_t entries_max = 254;  ///< of 6740h
  static constexpr std::size_t message_size = 64;  ///< bytes of a message at most
  static constexpr std::size_t file_size = 16384;  ///< bytes of 6741h at most
  static constexpr unsigned many = 200;            ///< more entries of a list cause an event

  /// Makes the unit; `device` must outlive it.
  DiagnosticsUnit(VirtualDevice& device, const NoHardware& hardware,
                  const DiagnosticsSettings& settings);

  /// Reports an error like a write to 6740h:01h.
  void report(std::uint16_t device_code, std::uint16_t error_code);
  /// Reports a message like a write to sub-index 01h. False if there is no room, or if it is longer
  /// than 64 characters of 7-bit ASCII.
  bool report(ErrorClass error_class, std::string_view message);
  /// Content of 6741h: a line for each report.
  std::string_view file() const { return {file_.data(), file_length_}; }

 private:
  static const AccessHandlers hook_calls[];

  using Message = std::array<std::uint8_t, message_size>;
  struct Messages {
    std::array<Message, entries_max> messages{};
    std::array<bool, entries_max> is_read{};
    std::size_t count = 0;
  };

  void reset(ResetScope scope);
  AbortCode check_shorts(const Entry& entry, std::span<const std::uint8_t> value);
  void shorts_written(const Entry& entry);
  AbortCode check_messages(const Entry& entry, std::span<const std::uint8_t> value);
  void messages_written(const Entry& entry);
  void about_to_be_read(const Entry& entry);
  Messages* messages_of(std::uint16_t index);
  void add_short(std::uint32_t error);
  void add_message(std::uint16_t index, std::span<const std::uint8_t> text);
  void remove_messages(std::uint16_t index, bool all);
  void report_shorts();
  void report_messages(std::uint16_t index);
  void report_events();
  void add_line(std::string_view text);
  void drop_lines(std::size_t needed);
  void drop(std::size_t length);
  Result<std::uint32_t> open_read(const Entry& entry);
  Result<std::size_t> read(const Entry& entry, std::uint32_t offset, std::span<std::uint8_t> bytes);
  AbortCode open_write(const Entry& entry, std::uint32_t size);
  AbortCode write(const Entry& entry, std::span<const std::uint8_t> bytes);
  AbortCode close_write(const Entry& entry, bool complete);

  VirtualDevice& device_;
  DiagnosticsSettings settings_;
  std::array<std::uint32_t, entries_max> shorts_{};
  std::size_t short_count_ = 0;
  std::array<Messages, 3> classes_;
  std::array<char, file_size> file_{};
  std::size_t file_length_ = 0;
  std::uint32_t dropped_ = 0;      ///< bytes dropped at the beginning of the file, modulo 2^32
  std::uint32_t read_from_ = 0;    ///< dropped_ at the start of reading
  std::uint32_t read_length_ = 0;  ///< of the file at that time
  std::size_t written_ = 0;        ///< bytes of a written zero, which erases
  Domain domain_;
  Hook hook_;
};

/// Catalogue row of the diagnostics device (6.23); bus_unit makes it a part of a device.
struct DiagnosticsKind : BusKind<DiagnosticsUnit, NoHardware, DiagnosticsSettings> {
  static constexpr DeviceInfo info = {.name = "diagnostics",
                                      .title = "diagnostics device of a bus",
                                      .product = "Canvoy CiA 407 diagnostics",
                                      .product_code = 40722,
                                      .node_id = 22};
  static constexpr const VirtualDeviceInfo& provides = diagnostics;
  static constexpr std::array pdos = {own_pdo<event_tpdo>, own_pdo<error_count_tpdo>,
                                      own_pdo<position_rpdo>};
};

}  // namespace canvoy::cia407
