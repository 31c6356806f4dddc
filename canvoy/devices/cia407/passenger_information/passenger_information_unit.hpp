// Passenger information: shows the objects of its display mapping (6203h) when sub-index 01h of it
// is written (CiA 407, 6.4, 9.2.8). An object that cannot be shown is left out, and causes an error
// (FF04h) and an event until the next update. So does a character that the display cannot draw.
//
//     PassengerInformationUnit display(device, {.show = ...}, {});
//
// Writing a text shows nothing, and neither does a change of a shown value; only the next update
// does. Nothing is shown after a reset, and when the node leaves operational: a device that does
// not receive the on-board computer (1016h, 1029h) cannot know whether the contents still hold.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "canvoy/devices/cia407/kit/bus_kind.hpp"
#include "canvoy/devices/cia407/kit/file_shelf.hpp"
#include "canvoy/devices/cia407/kit/state_answer.hpp"
#include "canvoy/profiles/cia407/devices.hpp"
#include "canvoy/profiles/cia407/passenger_information.hpp"

namespace canvoy::cia407 {

/// Contents of a passenger information device of CiA 407, element by element, as in 6203h
/// (9.2.8.4). The hardware arranges them.
///
///     void show(std::span<const ShownElement> elements);   // from the upper left on
struct ShownElement {
  /// What the bytes of an element are.
  enum class Content : std::uint8_t {
    text,     ///< plain
    xml,      ///< of 6200h, with its format in the text
    picture,  ///< of 6202h: a file
  };
  Content content = Content::text;  ///< see Content
  /// Valid while the hardware's callback runs.
  std::span<const std::uint8_t> octets;
  /// For plain texts, as in 6205h: 0 ISO 646-US, n ISO 8859-n.
  std::uint16_t character_set = 0;
  FontSize size = FontSize::no_mode;
  Alignment alignment = Alignment::no_mode;  ///< of a text
  FontStyle style = FontStyle::no_mode;      ///< of a text
  FlashSpeed flash = FlashSpeed::no_flash;   ///< of a text
};

/// The display.
struct DisplayHardware {
  /// Shows exactly these elements, and removes all others.
  Callback<void(std::span<const ShownElement>)> show = {};
  /// Switches test mode on (every dot is lit) or off (the former contents).
  Callback<void(bool)> test = {};
  /// Switches the sign that the vehicle will stop (6204h).
  Callback<void(bool)> show_stop_request = {};
  /// True for a character set, 1 to 15 as in 6205h, of which the display can draw each character;
  /// absent: for each ISO 8859-n.
  Callback<bool(std::uint16_t)> has_character_set = {};
  /// False where the display has no picture of a character of the element, or its set has no such
  /// character; absent: always true.
  Callback<bool(const ShownElement&)> has_characters_of = {};
};
/// Sets it to the member functions of a plain class that have these names: see PlainHardware.
template <class Plain>
constexpr void set_by_names(DisplayHardware& hardware, Plain& plain) {
  static_assert(
      requires { &Plain::show; } || requires { &Plain::test; } ||
          requires { &Plain::show_stop_request; } || requires { &Plain::has_character_set; } ||
          requires { &Plain::has_characters_of; },
      "the class has no member function of DisplayHardware: show, test, show_stop_request, "
      "has_character_set or has_characters_of");
  if constexpr (requires { &Plain::show; }) hardware.show = callback<&Plain::show>(plain);
  if constexpr (requires { &Plain::test; }) hardware.test = callback<&Plain::test>(plain);
  if constexpr (requires { &Plain::show_stop_request; })
    hardware.show_stop_request = callback<&Plain::show_stop_request>(plain);
  if constexpr (requires { &Plain::has_character_set; })
    hardware.has_character_set = callback<&Plain::has_character_set>(plain);
  if constexpr (requires { &Plain::has_characters_of; })
    hardware.has_characters_of = callback<&Plain::has_characters_of>(plain);
}

class PassengerInformationUnit {
 public:
  static constexpr std::size_t elements_max = 32;  ///< of a display mapping
  // Maximum bytes of a file, and number of files.
  static constexpr std::size_t special_characters = 16;       ///< files
  static constexpr std::size_t special_character_size = 256;  ///< bytes of each
  static constexpr std::size_t pictures = 8;                  ///< files
  static constexpr std::size_t picture_size = 8192;           ///< bytes of each

  /// Everything to which `hardware` refers must outlive this.
  PassengerInformationUnit(VirtualDevice& device, const DisplayHardware& hardware,
                           const NoSettings& settings);

  /// Files of characters that 6202h stores.
  FileShelf& special_character_files() { return special_characters_.shelf(); }

 private:
  static const AccessHandlers hook_calls[];

  static constexpr std::size_t number_size = 16;
  using NumberText = std::array<char, number_size>;

  void reset(ResetScope scope);
  void offer_character_sets();
  bool can_draw(const ShownElement& element) const;
  AbortCode check_character_set(std::uint16_t wanted);
  void stop_request_written();
  void take_event(std::uint8_t flags, std::uint16_t information);
  void state_entered(NmtState state);
  void go_dark();
  void update();
  bool fill(ShownElement& element, NumberText& number, std::uint32_t mapping);
  bool fill_content(ShownElement& element, NumberText& number, std::uint16_t index,
                    std::uint8_t sub);
  bool fill_file(ShownElement& element, std::uint16_t index, std::uint8_t sub);
  void tell_failure(bool has_failed);

  VirtualDevice& device_;
  DisplayHardware hardware_;
  StateAnswer state_;
  FileShelfOf<special_characters, special_character_size> special_characters_;
  FileShelfOf<pictures, picture_size> pictures_;
  static const ServiceHandlers service_calls;
  HandlerBinding service_{&service_calls, this};
  bool was_operational_ = false;
  bool is_testing_ = false;
};

// By class and subclass, and by class.
/// In the catalogue.
inline constexpr std::string_view display_names[] = {
    "destination-indicator-simple",   "destination-indicator-text",
    "destination-indicator-graphics", "destination-indicator-extended",
    "next-stop-indicator-simple",     "next-stop-indicator-text",
    "next-stop-indicator-graphics",   "next-stop-indicator-extended",
    "information-indicator-simple",   "information-indicator-text",
    "information-indicator-graphics", "information-indicator-extended"};
/// In the catalogue.
inline constexpr std::string_view display_titles[] = {
    "destination indicator, simple",   "destination indicator with text",
    "destination indicator, graphics", "destination indicator, extended",
    "next stop indicator, simple",     "next stop indicator with text",
    "next stop indicator, graphics",   "next stop indicator, extended",
    "information indicator, simple",   "information indicator with text",
    "information indicator, graphics", "information indicator, extended"};
/// Device names, 1008h.
inline constexpr const char* display_products[] = {
    "Canvoy CiA 407 destination", "Canvoy CiA 407 next stop", "Canvoy CiA 407 information"};
inline constexpr NodeId display_node_ids[] = {4, 5, 8};  ///< by class

/// For a class and a subclass.
template <InformationClass device_class, InformationSubclass subclass>
struct PassengerInformationKind : BusKind<PassengerInformationUnit, DisplayHardware> {
  static constexpr const VirtualDeviceInfo& provides =
      passenger_information<device_class, subclass>;

  static constexpr std::size_t class_number =
      static_cast<std::size_t>(device_class) - 1;  ///< 0 to 2
  /// 0 to 3: simple, text, graphics, extended.
  static constexpr std::size_t subclass_number = static_cast<std::size_t>(subclass) - 1;
  static constexpr std::size_t number = class_number * 4 + subclass_number;  ///< 0 to 11
  static constexpr DeviceInfo info = {
      .name = display_names[number],
      .title = display_titles[number],
      .product = display_products[class_number],
      .product_code = 40731 + static_cast<std::uint32_t>(number),
      .node_id = display_node_ids[class_number],
      .hardware = "a display: texts, pictures, a stop sign, test mode"};

  static constexpr std::array pdos = {own_pdo<event_tpdo>, own_pdo<command_rpdo>,
                                      own_pdo<call_rpdo>, own_pdo<stop_request_rpdo>};
};

}  // namespace canvoy::cia407
