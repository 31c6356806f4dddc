// CiA 852: indicator clusters and displays (9.7, 9.8), as entries of the CiA 401 outputs.
//
//     // "Indicator cluster #: Indicator 1-to-8"
//     find_entry(cia852::write_output_8_bit_object, 1)->name;
#pragma once

#include "canvoy/profiles/cia401/analogue.hpp"
#include "canvoy/profiles/cia401/digital.hpp"
#include "canvoy/profiles/cia852/values.hpp"

namespace canvoy::cia852 {

inline constexpr std::string_view if_indicators = "if the indicators are supported";
inline constexpr std::string_view if_display = "if the parameter of the display is supported";

// Indicators.

/// Names of the entries of a cluster, by group.
using ClusterNames = std::array<std::string_view, groups_of_cluster>;
/// The word as in Figure 8 (errata 10).
inline constexpr ClusterNames indicator_names = {
    "Indicator cluster #: Indicator 1-to-8",   "Indicator cluster #: Indicator 9-to-16",
    "Indicator cluster #: Indicator 17-to-24", "Indicator cluster #: Indicator 25-to-32",
    "Indicator cluster #: Indicator 33-to-40", "Indicator cluster #: Indicator 41-to-48",
    "Indicator cluster #: Indicator 49-to-56", "Indicator cluster #: Indicator 57-to-64"};
inline constexpr ClusterNames indicator_error_mode_names = {
    "Indicator cluster #: Error mode 1-to-8",   "Indicator cluster #: Error mode 9-to-16",
    "Indicator cluster #: Error mode 17-to-24", "Indicator cluster #: Error mode 25-to-32",
    "Indicator cluster #: Error mode 33-to-40", "Indicator cluster #: Error mode 41-to-48",
    "Indicator cluster #: Error mode 49-to-56", "Indicator cluster #: Error mode 57-to-64"};
inline constexpr ClusterNames indicator_error_value_names = {
    "Indicator cluster #: Error value 1-to-8",   "Indicator cluster #: Error value 9-to-16",
    "Indicator cluster #: Error value 17-to-24", "Indicator cluster #: Error value 25-to-32",
    "Indicator cluster #: Error value 33-to-40", "Indicator cluster #: Error value 41-to-48",
    "Indicator cluster #: Error value 49-to-56", "Indicator cluster #: Error value 57-to-64"};

inline constexpr unsigned indicator_entry_count = indicator_clusters_max * groups_of_cluster + 1;

/// The number of an entry is its sub-index (Table 6).
constexpr std::array<EntryInfo, indicator_entry_count> indicator_entries(
    const EntryInfo& each, const ClusterNames& names) {
  std::array<EntryInfo, indicator_entry_count> entries{highest_sub_index};
  for (unsigned n = 1; n <= indicator_clusters_max; ++n) {
    for (unsigned group = 1; group <= groups_of_cluster; ++group) {
      const unsigned sub = indicators_sub(n, group);
      entries[sub] = element(sub, n, names[group - 1], each, if_indicators, "9.7");
    }
  }
  return entries;
}

inline constexpr auto write_output_8_bit_entries =
    indicator_entries({.type = DataType::unsigned8,
                       .access = Access::rw,
                       .mapping = Mapping::by_default,
                       .value = {.notation = Notation::bit_mask},
                       .fields = indicator_fields,
                       .errata = "2, 9",
                       .description = "Eight indicators of a cluster."},
                      indicator_names);
inline constexpr auto write_output_8_bit_object =
    array_object(cia401::write_output_8_bit_object.index, cia401::write_output_8_bit_object.name,
                 "9.7", "What the indicators show.", write_output_8_bit_entries,
                 {.category = Category::optional, .errata = "2, 9, 10, 11, 49"});

inline constexpr auto error_mode_output_8_bit_entries =
    indicator_entries({.type = DataType::unsigned8,
                       .access = Access::rw,
                       .initial = 0x01,
                       .value = {.notation = Notation::bit_mask},
                       .fields = indicator_error_mode_fields,
                       .errata = "3, 12",
                       .description = "Which indicators take their error value on a failure."},
                      indicator_error_mode_names);
inline constexpr auto error_mode_output_8_bit_object = array_object(
    cia401::error_mode_output_8_bit_object.index, cia401::error_mode_output_8_bit_object.name,
    "9.7", "What the indicators do on a failure: one bit for each.",
    error_mode_output_8_bit_entries, {.category = Category::optional, .errata = "3, 12, 49"});

inline constexpr auto error_value_output_8_bit_entries =
    indicator_entries({.type = DataType::unsigned8,
                       .access = Access::rw,
                       .initial = 0,
                       .value = {.notation = Notation::bit_mask},
                       .fields = indicator_fields,
                       .errata = "3",
                       .description = "What eight indicators show on a failure."},
                      indicator_error_value_names);
inline constexpr auto error_value_output_8_bit_object = array_object(
    cia401::error_value_output_8_bit_object.index, cia401::error_value_output_8_bit_object.name,
    "9.7", "What the indicators show on a failure.", error_value_output_8_bit_entries,
    {.condition = "if 6206h has the value 1", .errata = "3, 49"});

// Displays: matrix displays, bar graphs and round meters.

/// Names of the entries of a display, by parameter.
using DisplayNames = std::array<std::string_view, parameters_of_display>;
inline constexpr DisplayNames display_names = {
    "Display #: parameter 1",  "Display #: parameter 2",  "Display #: parameter 3",
    "Display #: parameter 4",  "Display #: parameter 5",  "Display #: parameter 6",
    "Display #: parameter 7",  "Display #: parameter 8",  "Display #: parameter 9",
    "Display #: parameter 10", "Display #: parameter 11", "Display #: parameter 12"};
inline constexpr DisplayNames display_error_mode_names = {
    "Error mode display #: parameter 1",  "Error mode display #: parameter 2",
    "Error mode display #: parameter 3",  "Error mode display #: parameter 4",
    "Error mode display #: parameter 5",  "Error mode display #: parameter 6",
    "Error mode display #: parameter 7",  "Error mode display #: parameter 8",
    "Error mode display #: parameter 9",  "Error mode display #: parameter 10",
    "Error mode display #: parameter 11", "Error mode display #: parameter 12"};
inline constexpr DisplayNames display_error_value_names = {
    "Error value display #: parameter 1",  "Error value display #: parameter 2",
    "Error value display #: parameter 3",  "Error value display #: parameter 4",
    "Error value display #: parameter 5",  "Error value display #: parameter 6",
    "Error value display #: parameter 7",  "Error value display #: parameter 8",
    "Error value display #: parameter 9",  "Error value display #: parameter 10",
    "Error value display #: parameter 11", "Error value display #: parameter 12"};

inline constexpr unsigned display_entry_count = displays_max * parameters_of_display + 1;
/// Sub-index 00h, and the parameters of all displays.
using DisplayEntries = std::array<EntryInfo, display_entry_count>;

/// Table 7.
constexpr DisplayEntries display_entries(const EntryInfo& each, const DisplayNames& names,
                                         unsigned pitch) {
  DisplayEntries entries{highest_sub_index};
  unsigned place = 1;
  for (unsigned n = 1; n <= displays_max; ++n) {
    for (unsigned parameter = 1; parameter <= parameters_of_display; ++parameter, ++place) {
      const unsigned sub = display_sub(n, parameter, pitch);
      entries[place] = element(sub, n, names[parameter - 1], each, if_display, "9.8");
    }
  }
  return entries;
}
/// The five objects of displays, in one of the two readings of Table 7.
struct DisplayTable {
  DisplayEntries integers{};        ///< 6411h
  DisplayEntries floats{};          ///< 6413h
  DisplayEntries error_modes{};     ///< 6443h
  DisplayEntries error_integers{};  ///< 6444h
  DisplayEntries error_floats{};    ///< 6445h
};
/// The table with `pitch` sub-indices for each display.
constexpr DisplayTable display_table(unsigned pitch) {
  // An analogue value; no clause gives its unit.
  const ValueInfo shown = {.counting = Counting::counts};
  const EntryInfo integer = {.type = DataType::integer16,
                             .access = Access::rw,
                             .mapping = Mapping::by_default,
                             .initial = 0,
                             .value = shown,
                             .errata = "5"};
  const EntryInfo real = {.type = DataType::real32,
                          .access = Access::rw,
                          .mapping = Mapping::optional,
                          .initial = 0,
                          .value = shown,
                          .errata = "5, 6"};
  const EntryInfo error_mode = {.type = DataType::unsigned8,
                                .access = Access::rw,
                                .initial = 0x01,
                                .value = {.names = cia401::error_mode_byte_names},
                                .errata = "4, 5"};
  const EntryInfo error_integer = {.type = DataType::integer32,
                                   .access = Access::rw,
                                   .initial = 0,
                                   .value = shown,
                                   .errata = "4, 5"};
  const EntryInfo error_real = {.type = DataType::real32,
                                .access = Access::rw,
                                .initial = 0,
                                .value = shown,
                                .errata = "4, 5, 6"};
  return {display_entries(integer, display_names, pitch),
          display_entries(real, display_names, pitch),
          display_entries(error_mode, display_error_mode_names, pitch),
          display_entries(error_integer, display_error_value_names, pitch),
          display_entries(error_real, display_error_value_names, pitch)};
}
inline constexpr DisplayTable displays = display_table(display_pitch);
inline constexpr DisplayTable wide_displays = display_table(wide_display_pitch);

/// The object of CiA 401 with these entries.
constexpr ObjectInfo display_object(const ObjectInfo& generic, const DisplayEntries& entries,
                                    std::string_view condition, std::string_view description) {
  return {.index = generic.index,
          .code = ObjectCode::array,
          .name = generic.name,
          .category = condition.empty() ? Category::optional : Category::conditional,
          .condition = condition,
          .clause = "9.8",
          .errata = "4, 5, 6, 49",
          .description = description,
          .subs = entries};
}
/// 6411h.
constexpr ObjectInfo display_integer_object(const DisplayTable& table) {
  return display_object(cia401::write_analogue_output_16_bit_object, table.integers, "",
                        "What displays show, as numbers.");
}
/// 6413h.
constexpr ObjectInfo display_float_object(const DisplayTable& table) {
  return display_object(cia401::write_analogue_output_float_object, table.floats, "",
                        "What displays show, as floating-point numbers.");
}
/// 6443h.
constexpr ObjectInfo display_error_mode_object(const DisplayTable& table) {
  return display_object(cia401::analogue_output_error_mode_object, table.error_modes, "",
                        "Whether displays take their error values on a failure.");
}
/// 6444h.
constexpr ObjectInfo display_error_integer_object(const DisplayTable& table) {
  return display_object(cia401::analogue_output_error_value_integer_object, table.error_integers,
                        "if 6411h is supported", "What displays of 6411h show on a failure.");
}
/// 6445h.
constexpr ObjectInfo display_error_float_object(const DisplayTable& table) {
  return display_object(cia401::analogue_output_error_value_float_object, table.error_floats,
                        "if 6413h is supported", "What displays of 6413h show on a failure.");
}

inline constexpr ObjectInfo write_analogue_output_16_bit_object = display_integer_object(displays);
inline constexpr ObjectInfo write_analogue_output_float_object = display_float_object(displays);
inline constexpr ObjectInfo analogue_output_error_mode_object = display_error_mode_object(displays);
inline constexpr ObjectInfo analogue_output_error_value_integer_object =
    display_error_integer_object(displays);
inline constexpr ObjectInfo analogue_output_error_value_float_object =
    display_error_float_object(displays);

/// Display objects with 24 sub-indices for each display.
inline constexpr ObjectInfo wide_display_objects[] = {
    display_integer_object(wide_displays), display_float_object(wide_displays),
    display_error_mode_object(wide_displays), display_error_integer_object(wide_displays),
    display_error_float_object(wide_displays)};

}  // namespace canvoy::cia852
