// The printer: prints text, graphics and logos from one transport object (60E0h to 60EBh; CiA
// 447-3, 4.2.13).
//
//     PaperPicture picture;
//     PrinterUnit printer(network, {.paper = picture.paper()}, {});
//     printer.sense_paper(false);   // it has run out
//
// A transport is printed as it arrives, from one client at a time. Other clients, and all clients
// while there is no paper, get 0800 0022h. The printer is busy until the paper has moved as far as
// was printed.
#pragma once

#include <array>

#include "canvoy/devices/cia447/kit/car_kind.hpp"
#include "canvoy/devices/cia447/kit/commands.hpp"
#include "canvoy/devices/cia447/printer/print_stream.hpp"
#include "canvoy/devices/cia447/printer/printer_font.hpp"
#include "canvoy/profiles/cia447/devices.hpp"
#include "canvoy/profiles/cia447/equipment_handles.hpp"

namespace canvoy::cia447 {

/// The mechanism.
struct PrinterHardware {
  PrinterPaper paper = {};  ///< prints and moves it
};
/// Sets it to the member functions of a plain class that have these names: see PlainHardware.
template <class Plain>
constexpr void set_by_names(PrinterHardware& hardware, Plain& plain) {
  static_assert(
      requires { &Plain::put; } || requires { &Plain::width; } || requires { &Plain::put_row; } ||
          requires { &Plain::feed; } || requires { &Plain::cut; },
      "the class has no member function of PrinterHardware: put, width, put_row, feed or cut");
  if constexpr (requires { &Plain::put; }) hardware.paper.put = callback<&Plain::put>(plain);
  if constexpr (requires { &Plain::width; }) hardware.paper.width = callback<&Plain::width>(plain);
  if constexpr (requires { &Plain::put_row; })
    hardware.paper.put_row = callback<&Plain::put_row>(plain);
  if constexpr (requires { &Plain::feed; }) hardware.paper.feed = callback<&Plain::feed>(plain);
  if constexpr (requires { &Plain::cut; }) hardware.paper.cut = callback<&Plain::cut>(plain);
}

/// Capabilities of the printer (60E2h).
struct PrinterAbilities {
  bool text = true;            ///< characters
  bool bold = true;            ///< heavy strokes
  bool cursive = true;         ///< slanted characters
  bool variable_width = true;  ///< characters of their own width
  bool black = true;           ///< graphics in black
  bool gray = true;            ///< graphics in shades of gray
  bool rgb = true;             ///< graphics in red, green, blue
  bool cmyk = true;            ///< graphics in cyan, magenta, yellow, black
  bool cut = true;             ///< a knife
};
/// Properties of the printer.
struct PrinterSettings {
  PrinterAbilities can = {};                ///< 60E2h
  PrinterFontLimits font = {};              ///< sizes of characters
  std::span<const PrinterLogo> logos = {};  ///< 20 at most; must outlive the unit
  /// Number of new lines after which the last text can be torn off, 1 to 5, which the client sends;
  /// 0: the printer feeds `automatic_lines` by itself at the end of printing.
  unsigned lines_to_form_feed = 3;
  unsigned automatic_lines = 3;  ///< lines that it feeds itself at the end of printing
  /// Speed of the paper.
  unsigned dots_per_second = 400;
};

/// State of the mechanism.
enum class PrinterMechanism : std::uint8_t { working, standby, failure };

class PrinterUnit {
 public:
  /// Everything to which `hardware` and `settings` refer must outlive this.
  PrinterUnit(CarNetwork& network, const PrinterHardware& hardware,
              const PrinterSettings& settings);

  /// Reports whether there is paper.
  void sense_paper(bool is_there);
  /// Sets the state of the mechanism. A printer in standby wakes up for a transport.
  void sense(PrinterMechanism mechanism);

  /// True while data comes, or the mechanism works.
  bool is_busy() const { return is_transporting_ || busy_until_ > network_.node().now(); }
  /// Contents that are being printed.
  const PrintStream& stream() const { return stream_; }

 private:
  void reset(ResetScope scope);
  AbortCode refuses(const Commanded& wanted);
  bool allows(PrinterMode mode) const;
  bool allows(ColorSpaceCommand command) const;
  void commanded(const Commanded& wanted);
  void use_font();

  bool can_print() const { return has_paper_ && mechanism_ != PrinterMechanism::failure; }
  Result<std::uint32_t> read_back(const Entry& entry);
  AbortCode open(const Entry& entry, std::uint32_t size);
  AbortCode write(const Entry& entry, std::span<const std::uint8_t> bytes);
  AbortCode close(const Entry& entry, bool is_complete);
  void count_motion();
  void finished(Time now);

  void list_lacking();
  void report_state();
  void report_features();
  void report_sizes();
  void report_font();

  CarNetwork& network_;
  PrinterSettings settings_;
  Values values_;
  PrintStream stream_;
  PrinterFont font_;

  bool has_paper_ = true;
  PrinterMechanism mechanism_ = PrinterMechanism::working;
  bool is_transporting_ = false;
  bool wants_form_feed_ = false;
  std::uint32_t counted_ = 0;  ///< dots that busy_until_ already includes
  Time busy_until_{};

  std::array<FieldPlace, 8> lacking_{};
  std::size_t lacking_count_ = 0;
  Commands commands_;
  Domain domain_;
  Hook transport_hook_;
  static const ServiceHandlers service_calls;
  HandlerBinding service_{&service_calls, this};
  Timer timer_;
};

/// Catalogue row of the printer (4.2.13); car_unit makes it a part of a device.
struct PrinterKind : CarKind<PrinterUnit, PrinterHardware, PrinterSettings> {
  static constexpr DeviceInfo info = {.name = "printer",
                                      .title = "printer",
                                      .product = "Canvoy CiA 447 printer",
                                      .product_code = 44710,
                                      .node_id = 6,
                                      .hardware = "paper: characters and dots, feed, cut"};
  static constexpr const VirtualDeviceInfo& provides = printer_device;
};

}  // namespace canvoy::cia447
