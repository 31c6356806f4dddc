// The 24 virtual devices of CiA 407 and the objects of each (clause 6). Each combination of class
// and subclass is a separate device.
//
//     cia407::virtual_devices[0].objects  // those of the main on-board computer
#pragma once

#include <algorithm>
#include <array>
#include <concepts>

#include "canvoy/profiles/cia407/system.hpp"

namespace canvoy::cia407 {

// Access of a virtual device to an object: it provides the object (ro), consumes it from another
// device (wo), or the object is read and written (rw).

// Names as in the tables of clause 6. NOLINTBEGIN(readability-identifier-naming)
inline constexpr Category M = Category::mandatory;
inline constexpr Category O = Category::optional;
// NOLINTEND(readability-identifier-naming)

/// The device provides the object: ro.
constexpr DeviceObject provides(std::uint16_t index, Category category) {
  return {.index = index, .category = category, .access = Access::ro};
}
/// The device takes the object from another one: wo.
constexpr DeviceObject takes(std::uint16_t index, Category category) {
  return {.index = index, .category = category, .access = Access::wo, .consumed = true};
}
/// The object is read and written in the device.
constexpr DeviceObject provides_rw(std::uint16_t index, Category category) {
  return {.index = index, .category = category, .access = Access::rw};
}
/// The precision of a measured value (errata 104).
constexpr DeviceObject precision(DeviceObject object, std::string_view condition) {
  object.category = Category::conditional;
  object.condition = condition;
  return object;
}
/// The same with a remark in place of a condition.
constexpr DeviceObject with_note(DeviceObject object, std::string_view note) {
  object.condition = note;
  return object;
}
inline constexpr std::string_view if_611a = "if object 611Ah is implemented";
inline constexpr std::string_view if_6482 = "if object 6482h is implemented";
inline constexpr std::string_view if_6486 = "if object 6486h is implemented";
inline constexpr std::string_view if_6660 = "if object 6660h is implemented";
inline constexpr std::string_view if_6664 = "if object 6664h is implemented";

// Where the bus has segments, another access holds (footnotes of 6.2, 6.3 and 6.10).
inline constexpr std::string_view identification_provides_texts =
    "wo or rw, where the identification device provides it";
inline constexpr std::string_view main_computer_takes_texts =
    "ro, where the main on-board computer takes it";
inline constexpr std::string_view no_main_computer =
    "ro, where the segment has no main on-board computer and no identification";
inline constexpr std::string_view no_diagnostics =
    "ro, where the segment has no diagnostics device";

/// A list of them, for VirtualDeviceInfo.
template <std::same_as<DeviceObject>... Object>
constexpr std::array<DeviceObject, sizeof...(Object)> device_objects(const Object&... objects) {
  return {objects...};
}

/// 6196h to 6198h: it is open which device provides them (errata 26).
constexpr DeviceObject provides_text(std::uint16_t index) {
  return with_note(provides(index, O), identification_provides_texts);
}
/// 6196h to 6198h in a device that shows them.
constexpr DeviceObject takes_text(std::uint16_t index) {
  return with_note(takes(index, O), main_computer_takes_texts);
}

inline constexpr auto main_on_board_computer_objects = device_objects(
    takes(0x6001, M), provides(0x6002, M), provides(0x6100, O), provides(0x6101, O),
    provides(0x6102, O), provides(0x6103, O), provides(0x6104, O), provides(0x6105, O),
    provides(0x6106, O), provides(0x6107, O), provides(0x6108, M), provides(0x6109, M),
    provides(0x610A, O), provides(0x610B, O), provides(0x610C, O), provides(0x610D, O),
    provides(0x610E, M), provides(0x610F, O), provides(0x6110, M), provides(0x6111, M),
    provides(0x6112, O), provides(0x6113, O), provides(0x6114, O), provides(0x6115, O),
    provides(0x6116, O), provides(0x6117, O), provides(0x6118, O), provides(0x6119, O),
    provides(0x611A, O), precision(provides(0x611B, O), if_611a), provides(0x611C, O),
    provides(0x611D, O), provides(0x611E, O), provides(0x611F, O), provides(0x6120, O),
    provides(0x6121, O), provides(0x6122, O), provides(0x6123, O), takes(0x6190, M),
    takes(0x6191, M), takes(0x6192, M), takes(0x6193, M), takes(0x6194, M), takes(0x6195, M),
    provides_text(0x6196), provides_text(0x6197), provides_text(0x6198), provides(0x6204, M),
    takes(0x6481, O), takes(0x6482, O), precision(takes(0x6483, O), if_6482), takes(0x6484, O),
    takes(0x6486, O), precision(takes(0x6487, O), if_6486), takes(0x6488, O), takes(0x6489, O),
    takes(0x6520, O), takes(0x6522, O), takes(0x6660, O), precision(takes(0x6661, O), if_6660),
    takes(0x6662, O), takes(0x6663, O), takes(0x6664, O), precision(takes(0x6665, O), if_6664),
    takes(0x6680, O), takes(0x6720, O), takes(0x6721, O), takes(0x6722, O), takes(0x6723, O),
    takes(0x6740, M), takes(0x6741, O), takes(0x6742, O), takes(0x6743, O), takes(0x6744, O));

inline constexpr auto identification_objects =
    device_objects(provides(0x6190, M), provides(0x6191, M), provides(0x6192, M),
                   provides(0x6193, O), provides(0x6194, M), provides(0x6195, M),
                   takes_text(0x6196), takes_text(0x6197), takes_text(0x6198));

/// A row of the matrix in 6.4: categories of classes 1, 2 and 3, with subclasses 1 to 4 of each.
struct MatrixRow {
  std::uint16_t index;           ///< of the object
  std::string_view categories;   ///< M, O or - for each column, with spaces between the classes
  Access access;                 ///< as it is printed
  std::string_view errata = {};  ///< finding by which that of the entries holds instead
};
inline constexpr MatrixRow passenger_information_matrix[] = {
    {0x6001, "OOOO OOOO OOOO", Access::ro},       {0x6002, "OOOO OOOO OOOO", Access::wo},
    {0x6101, "-OOO -OOO -OOO", Access::wo},       {0x6109, "---O MMMM MMMM", Access::wo},
    {0x610B, "-OMM MMMM MMMM", Access::wo},       {0x610C, "OOOO ---- OMOO", Access::wo},
    {0x610D, "-MOO -OOO -MOO", Access::wo},       {0x610E, "---O ---O ---O", Access::wo},
    {0x6110, "MMMM ---- MMMM", Access::wo},       {0x6112, "-OOO -MOO -MOO", Access::wo},
    {0x6119, "---O ---O -OOO", Access::wo},       {0x611D, "-OOO -OOO -OOO", Access::wo},
    {0x6120, "---O MMMM MMMM", Access::wo},       {0x6121, "OOOO OOOO OOOO", Access::wo},
    {0x6123, "---O ---O -OOO", Access::wo},       {0x6191, "MMMM MMMM MMMM", Access::wo},
    {0x6192, "OMMM OMMM MMMM", Access::wo},       {0x6193, "MMMM MMMM MMMM", Access::wo},
    {0x6196, "OMMM OMMM MMMM", Access::wo},       {0x6200, "OOOO OOOO OOMO", Access::rw},
    {0x6201, "-OOO OOOO OOOO", Access::rw},       {0x6202, "OOOO OOOO OOMO", Access::rw},
    {0x6203, "MMMM MMMM MMMM", Access::rw},       {0x6204, "---- -OOO OOOO", Access::wo},
    {0x6205, "---- -OOO OOOO", Access::wo, "29"},  // rw and ro, by sub-index
    {0x6481, "---O ---O -OOO", Access::wo},       {0x6488, "---O ---O -OOO", Access::wo},
    {0x6489, "---O ---O -OOO", Access::wo},       {0x6520, "---O ---O -OOO", Access::wo},
    {0x6662, "---O ---O -OOO", Access::wo},       {0x6740, "---- ---- OOOO", Access::wo},
    {0x6741, "---- ---- OOOO", Access::wo},       {0x6742, "---- ---- OOOO", Access::wo},
    {0x6743, "---- ---- OOOO", Access::wo},       {0x6744, "---- ---- OOOO", Access::wo},
};
/// Column of a class and a subclass in a row.
constexpr std::size_t matrix_column(unsigned device_class, unsigned subclass) {
  return (device_class - 1) * 5 + subclass - 1;
}
/// Objects of one column.
template <std::size_t column>
constexpr auto passenger_information_column() {
  constexpr auto has = [](const MatrixRow& row) { return row.categories[column] != '-'; };
  constexpr auto count = std::ranges::count_if(passenger_information_matrix, has);
  std::array<DeviceObject, static_cast<std::size_t>(count)> objects{};
  std::size_t size = 0;
  for (const MatrixRow& row : passenger_information_matrix) {
    if (!has(row)) continue;
    const bool holds = row.errata.empty();
    objects[size++] = {.index = row.index,
                       .category = row.categories[column] == 'M' ? M : O,
                       .access = holds ? row.access : Access::none,
                       .consumed = holds && row.access == Access::wo,
                       .printed_access = holds ? Access::none : row.access,
                       .errata = row.errata};
  }
  return objects;
}
template <InformationClass device_class, InformationSubclass subclass>
inline constexpr auto passenger_information_objects = passenger_information_column<matrix_column(
    static_cast<unsigned>(device_class), static_cast<unsigned>(subclass))>();

inline constexpr auto ticket_canceller_objects = device_objects(
    provides(0x6001, O), takes(0x6002, O), takes(0x6100, O), takes(0x6105, O), takes(0x6108, M),
    takes(0x6109, M), takes(0x610A, O), takes(0x610B, O), takes(0x610E, M), takes(0x6110, M),
    takes(0x6111, M), takes(0x6112, O), takes(0x6116, O), takes(0x6118, O), takes(0x611C, O),
    takes(0x6120, M), takes(0x6191, M), takes(0x6192, M), takes(0x6193, O), takes(0x6194, M));
inline constexpr auto ticket_printer_objects = device_objects(
    takes(0x6100, O), takes(0x6108, M), takes(0x6109, M), takes(0x610A, O), takes(0x610B, O),
    takes(0x610C, O), takes(0x610E, M), takes(0x6110, M), takes(0x6111, M), takes(0x6112, M),
    takes(0x6116, O), takes(0x6118, O), takes(0x611C, O), takes(0x6120, M), takes(0x6191, M),
    takes(0x6192, M), takes(0x6193, M), takes(0x6194, M), takes(0x6196, M), takes(0x6197, O),
    takes(0x6740, M), takes(0x6741, O), takes(0x6742, O), takes(0x6743, O), takes(0x6744, O));
/// 6001h and 6002h are not listed in 6.8, but 9.2.5 has events for it (errata 22).
inline constexpr auto acoustic_announcer_objects =
    device_objects(provides(0x6001, O), takes(0x6002, O), takes(0x6109, M), takes(0x6120, O));
inline constexpr auto acoustic_control_manager_objects =
    device_objects(provides(0x6001, O), takes(0x6002, O));

/// The gateway relays the object in place of missing providers (footnotes of 6.10).
constexpr DeviceObject relays(std::uint16_t index, Category category) {
  return with_note(takes(index, category), no_main_computer);
}
/// The gateway relays the object in place of a missing diagnostics device.
constexpr DeviceObject relays_diagnostics(std::uint16_t index) {
  return with_note(takes(index, O), no_diagnostics);
}
/// Requests to stop are relayed in both directions.
constexpr DeviceObject relays_both_ways(std::uint16_t index, Category category) {
  DeviceObject object = relays(index, category);
  object.access = Access::rw;
  return object;
}
inline constexpr auto train_bus_gateway_objects = device_objects(
    relays(0x6100, O), relays(0x6101, O), relays(0x6102, O), relays(0x6103, O), relays(0x6104, O),
    relays(0x6105, O), relays(0x6106, O), relays(0x6107, O), relays(0x6108, M), relays(0x6109, M),
    relays(0x610A, O), relays(0x610B, O), relays(0x610C, O), relays(0x610D, O), relays(0x610E, M),
    relays(0x610F, O), relays(0x6110, M), relays(0x6111, M), relays(0x6112, O), relays(0x6113, O),
    relays(0x6114, O), relays(0x6115, O), relays(0x6116, O), relays(0x6117, O), relays(0x6118, O),
    relays(0x611C, O), relays(0x611D, O), relays(0x611E, O), relays(0x611F, O), relays(0x6120, O),
    relays(0x6121, O), relays(0x6123, O), relays(0x6190, M), relays(0x6191, M), relays(0x6192, M),
    relays(0x6193, M), relays(0x6194, M), relays(0x6195, M), relays(0x6196, O), relays(0x6197, O),
    relays_both_ways(0x6204, O), relays(0x6481, O), relays(0x6484, O), relays(0x6488, O),
    relays(0x6489, O), relays(0x6660, O), relays(0x6680, O), takes(0x6700, O), relays(0x6720, O),
    relays_diagnostics(0x6740), relays_diagnostics(0x6741), relays_diagnostics(0x6742),
    relays_diagnostics(0x6743), relays_diagnostics(0x6744));
inline constexpr auto vehicle_gateway_objects = device_objects(
    provides(0x610E, O), provides(0x6481, O), provides(0x6482, O),
    precision(provides(0x6483, O), if_6482), provides(0x6484, O), provides(0x6486, O),
    precision(provides(0x6487, O), if_6486), provides(0x6488, O), provides(0x6489, O),
    provides(0x648A, O), provides(0x648B, O), provides(0x648C, O), provides(0x648D, O));
inline constexpr auto driver_display_objects =
    device_objects(takes(0x610E, O), takes(0x6488, O), takes(0x6489, O), takes(0x648A, O),
                   takes(0x648B, O), takes(0x648C, O), takes(0x648D, O), takes(0x6740, O));
inline constexpr auto driver_display_with_keyboard_objects =
    device_objects(takes(0x610E, M), takes(0x6488, O), takes(0x6489, O), takes(0x648A, O),
                   takes(0x648B, O), takes(0x648C, O), takes(0x648D, O), takes(0x6740, O));
/// 6002h is not listed in 6.13, but 9.2.5 has events for it (errata 21).
inline constexpr auto tachograph_objects = device_objects(
    takes(0x6002, O), takes(0x6190, M), provides(0x6520, M), provides(0x6521, M),
    provides(0x6522, M), provides(0x6523, O), provides(0x6524, M), provides(0x6525, M));
/// 6661h and 6665h are listed as optional, but the values that they qualify are mandatory (errata
/// 104).
inline constexpr auto geographical_positioning_objects =
    device_objects(provides(0x6660, M), provides(0x6661, M), provides(0x6662, O),
                   provides(0x6663, O), provides(0x6664, M), provides(0x6665, M));
inline constexpr auto time_fixing_objects = device_objects(takes(0x6660, M), provides(0x6680, M));
inline constexpr auto keyboard_objects = device_objects(provides(0x66C0, O), provides(0x6760, M));
inline constexpr auto passenger_counter_objects =
    device_objects(provides(0x6001, O), takes(0x6002, O), takes(0x6488, O), provides(0x6700, M));
inline constexpr auto passenger_counting_manager_objects =
    device_objects(provides(0x6001, M), takes(0x6002, M), takes(0x6100, O), takes(0x6108, M),
                   takes(0x6109, M), takes(0x610E, M), takes(0x6191, M), takes(0x6192, M),
                   takes(0x6193, M), takes(0x6488, O), takes(0x6700, M), provides(0x6720, O),
                   provides(0x6721, M), provides(0x6722, M), provides(0x6723, O));
/// 6001h is not listed in 6.23, but 9.2.4 has events from the device (errata 23). 6741h is listed
/// as ro, but 9.2.27.2 describes writing to it (errata 91).
inline constexpr auto diagnostics_objects = device_objects(
    provides(0x6001, O), takes(0x610E, M), takes(0x6660, O), provides(0x6740, M),
    provides_rw(0x6741, O), provides(0x6742, O), provides(0x6743, O), provides(0x6744, O));
inline constexpr auto generic_io_objects = device_objects(
    provides(0x6760, O), provides_rw(0x6761, O), provides(0x6762, O), provides_rw(0x6763, O));

// The devices.

/// A virtual device with its code of Table 2.
constexpr VirtualDeviceInfo describe_device(DeviceCode code, std::string_view clause,
                                            std::string_view description,
                                            const Items<DeviceObject>& objects,
                                            std::string_view errata = {}) {
  return {.code = code_of(code),
          .name = name_of(code),
          .objects = objects,
          .clause = clause,
          .errata = errata,
          .description = description};
}
/// The passenger information device of a class and subclass.
template <InformationClass device_class, InformationSubclass subclass>
constexpr VirtualDeviceInfo make_passenger_information() {
  constexpr auto class_code = static_cast<std::uint8_t>(device_class);
  constexpr auto subclass_code = static_cast<std::uint8_t>(subclass);
  VirtualDeviceInfo made = describe_device(
      DeviceCode::passenger_information, "6.4", "Shows passengers what the vehicle does.",
      passenger_information_objects<device_class, subclass>, "5, 29");
  made.device_class = class_code;
  made.subclass = subclass_code;
  made.class_name = information_classes[class_code].name;
  made.subclass_name = information_subclasses[subclass_code].name;
  return made;
}
/// The vehicle driver indicator of a class.
constexpr VirtualDeviceInfo driver_indicator(IndicatorClass device_class,
                                             const Items<DeviceObject>& objects) {
  VirtualDeviceInfo made = describe_device(DeviceCode::vehicle_driver_indicator, "6.12",
                                           "Speaks with the driver.", objects, "6, 14");
  made.device_class = static_cast<std::uint8_t>(device_class);
  made.class_name = indicator_classes[made.device_class].name;
  return made;
}

template <InformationClass device_class, InformationSubclass subclass>
inline constexpr VirtualDeviceInfo passenger_information =
    make_passenger_information<device_class, subclass>();
inline constexpr VirtualDeviceInfo main_on_board_computer =
    describe_device(DeviceCode::main_on_board_computer, "6.2", "Controls the information system.",
                    main_on_board_computer_objects, "4, 8, 25, 26, 27, 104");
inline constexpr VirtualDeviceInfo identification =
    describe_device(DeviceCode::identification, "6.3", "Says who drives what today.",
                    identification_objects, "25, 26");
inline constexpr VirtualDeviceInfo ticket_canceller = describe_device(
    DeviceCode::ticket_canceller, "6.5", "Cancels tickets.", ticket_canceller_objects);
inline constexpr VirtualDeviceInfo ticket_printer =
    describe_device(DeviceCode::ticket_printer, "6.6", "Prints tickets.", ticket_printer_objects);
inline constexpr VirtualDeviceInfo ticket_reader = describe_device(
    DeviceCode::ticket_reader, "6.7", "Reads and checks tickets; its objects are open.", {}, "34");
inline constexpr VirtualDeviceInfo acoustic_announcer =
    describe_device(DeviceCode::acoustic_announcer, "6.8",
                    "Speaks to passengers, inside and outside: writing 6109h is the cue.",
                    acoustic_announcer_objects, "22");
inline constexpr VirtualDeviceInfo acoustic_control_manager = describe_device(
    DeviceCode::acoustic_control_manager, "6.9", "Switches microphones to loudspeakers and radio.",
    acoustic_control_manager_objects, "19, 20");
inline constexpr VirtualDeviceInfo train_bus_gateway = describe_device(
    DeviceCode::train_bus_gateway, "6.10", "Speaks with the other vehicles of the train.",
    train_bus_gateway_objects, "8, 31, 32");
inline constexpr VirtualDeviceInfo vehicle_gateway = describe_device(
    DeviceCode::vehicle_gateway, "6.11", "Speaks with the other networks of the vehicle.",
    vehicle_gateway_objects, "27, 104");
inline constexpr VirtualDeviceInfo driver_display =
    driver_indicator(IndicatorClass::display, driver_display_objects);
inline constexpr VirtualDeviceInfo driver_display_with_keyboard =
    driver_indicator(IndicatorClass::display_with_keyboard, driver_display_with_keyboard_objects);
inline constexpr VirtualDeviceInfo tachograph =
    describe_device(DeviceCode::tachograph, "6.13", "Records driving, as ISO 16844 has it.",
                    tachograph_objects, "21");
inline constexpr VirtualDeviceInfo data_radio =
    describe_device(DeviceCode::data_radio, "6.14",
                    "Data by radio, to the centre; its objects are open.", {}, "34");
inline constexpr VirtualDeviceInfo voice_radio =
    describe_device(DeviceCode::voice_radio, "6.15",
                    "Speech by radio, to the centre; its objects are open.", {}, "34");
inline constexpr VirtualDeviceInfo short_range_communication = describe_device(
    DeviceCode::short_range_communication, "6.16",
    "Data by radio or infrared, to the roadside or depot; its objects are open.", {}, "18, 34");
inline constexpr VirtualDeviceInfo geographical_positioning =
    describe_device(DeviceCode::geographical_positioning, "6.17",
                    "Says where the vehicle is, by GPS.", geographical_positioning_objects, "104");
inline constexpr VirtualDeviceInfo time_fixing = describe_device(
    DeviceCode::time_fixing, "6.18", "Says what time it is (UTC).", time_fixing_objects);
inline constexpr VirtualDeviceInfo drivers_console_display =
    describe_device(DeviceCode::drivers_console_display, "6.19",
                    "Shows the driver information; its objects are open.", {}, "15, 34");
inline constexpr VirtualDeviceInfo drivers_console_keyboard =
    describe_device(DeviceCode::drivers_console_keyboard, "6.20", "Keys and other digital inputs.",
                    keyboard_objects, "7, 18");
inline constexpr VirtualDeviceInfo passenger_counter =
    describe_device(DeviceCode::passenger_counter, "6.21", "Counts passengers at a door.",
                    passenger_counter_objects, "16");
inline constexpr VirtualDeviceInfo passenger_counting_manager =
    describe_device(DeviceCode::passenger_counting_manager, "6.22",
                    "Adds up the counts of all doors, and keeps them with the line.",
                    passenger_counting_manager_objects, "17");
inline constexpr VirtualDeviceInfo diagnostics =
    describe_device(DeviceCode::diagnostics, "6.23", "Collects what others report.",
                    diagnostics_objects, "23, 86, 87, 89, 90, 91");
inline constexpr VirtualDeviceInfo generic_io = describe_device(
    DeviceCode::generic_io, "6.24", "Digital and analogue inputs and outputs.", generic_io_objects);
inline constexpr VirtualDeviceInfo power_supply = describe_device(
    DeviceCode::power_supply, "6.25", "Supplies other devices; its objects are open.", {}, "34");

inline constexpr VirtualDeviceInfo virtual_devices[] = {
    main_on_board_computer,
    identification,
    passenger_information<InformationClass::destination, InformationSubclass::simple>,
    passenger_information<InformationClass::destination, InformationSubclass::text>,
    passenger_information<InformationClass::destination, InformationSubclass::graphics>,
    passenger_information<InformationClass::destination, InformationSubclass::extended>,
    passenger_information<InformationClass::next_stop, InformationSubclass::simple>,
    passenger_information<InformationClass::next_stop, InformationSubclass::text>,
    passenger_information<InformationClass::next_stop, InformationSubclass::graphics>,
    passenger_information<InformationClass::next_stop, InformationSubclass::extended>,
    passenger_information<InformationClass::information, InformationSubclass::simple>,
    passenger_information<InformationClass::information, InformationSubclass::text>,
    passenger_information<InformationClass::information, InformationSubclass::graphics>,
    passenger_information<InformationClass::information, InformationSubclass::extended>,
    ticket_canceller,
    ticket_printer,
    ticket_reader,
    acoustic_announcer,
    acoustic_control_manager,
    train_bus_gateway,
    vehicle_gateway,
    driver_display,
    driver_display_with_keyboard,
    tachograph,
    data_radio,
    voice_radio,
    short_range_communication,
    geographical_positioning,
    time_fixing,
    drivers_console_display,
    drivers_console_keyboard,
    passenger_counter,
    passenger_counting_manager,
    diagnostics,
    generic_io,
    power_supply,
};

}  // namespace canvoy::cia407
