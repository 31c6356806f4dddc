// Content of the data sheet of a device in any format: EDS and DCF (CiA 306), XDD and XDC (CiA
// 311). Values are kept as text, so that nothing is lost; sheet_number() reads them.
//
//     DataSheet sheet = read_eds(text, findings);
//     const SheetEntry* entry = sheet.find(0x1018, 1);
//     sheet_number(entry->default_value)->at(node_id);
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "canvoy/canopen/protocol/cob_id.hpp"
#include "canvoy/formats/eds/ini.hpp"
#include "canvoy/profiles/model/description.hpp"

namespace canvoy::formats {

/// A deviation in a data sheet.
struct Finding {
  /// An error makes a value useless; a warning is only against the standard.
  enum class Weight : std::uint8_t { error, warning };
  std::size_t line = 0;           ///< 0: the file as a whole
  std::string section = {};       ///< `1018sub1`, or the path of an element
  std::string text = {};          ///< description of the deviation
  std::string expected = {};      ///< the correct value; may be empty
  Weight weight = Weight::error;  ///< see Weight
};

/// A number in a data sheet, which may depend on the node-ID.
struct SheetNumber {
  /// If it depends on the node-ID, any node-ID can be added without overflow.
  std::int64_t number = 0;
  bool plus_node_id = false;  ///< the node-ID is added to it
  bool is_pattern = false;    ///< above the greatest number of 63 bits: `number` has its 64 bits

  /// The number for a node-ID.
  std::int64_t at(std::uint8_t node_id) const { return plus_node_id ? number + node_id : number; }
  friend bool operator==(const SheetNumber&, const SheetNumber&) = default;
};
/// Reads `0x1A`, `26`, `032` (octal), `-5`, `$NODEID+0x180`, `0x180+$NODEID`, in upper or lower
/// case. Nothing if the text is none of these, or has more than 64 bits.
std::optional<SheetNumber> sheet_number(std::string_view text);

/// A key of a section, and its value.
struct KeyValue {
  std::string key;    ///< as written; empty: a comment
  std::string value;  ///< as written, or the comment

  friend bool operator==(const KeyValue&, const KeyValue&) = default;
};

/// Content of one entry. Empty text: not given.
struct SheetEntry {
  std::string name = {};           ///< ParameterName
  unsigned object_type = 7;        ///< VAR
  unsigned data_type = 0;          ///< index of the type in the dictionary
  std::string access = {};         ///< as in the file: ro, wo, rw, rwr, rww, const
  std::string default_value = {};  ///< DefaultValue
  std::string low_limit = {};      ///< LowLimit
  std::string high_limit = {};     ///< HighLimit
  bool pdo_mapping = false;        ///< PDOMapping
  std::string obj_flags = {};      ///< ObjFlags
  std::string value = {};          ///< of a configured device (DCF, XDC)
  std::string denotation = {};     ///< Denotation, of a configured device
  /// Keys that CiA 306 does not define, and comments, which have an empty key.
  std::vector<KeyValue> others = {};
  std::size_t line = 0;  ///< in the file; 0: not from a file
};

/// Access that a sheet states, in the terms of a dictionary.
struct SaidAccess {
  Access by_sdo = Access::none;   ///< read, written or both
  Access in_pdos = Access::none;  ///< PDOs that may carry it, if it can be mapped
};
/// The meaning of `access` in upper or lower case; nothing if it is not defined (CiA 306).
std::optional<SaidAccess> said_access(const SheetEntry& entry);
/// True if the access is rw, rwr, rww or wo.
bool is_writable(const SheetEntry& entry);

/// An object with its entries.
struct SheetObject {
  /// List of the file in which the object stands.
  enum class Group : std::uint8_t { mandatory, optional, manufacturer, not_listed };
  Group group = Group::not_listed;  ///< by the index if the file has none
  SheetEntry own;                   ///< name, object type, and the whole entry of a variable
  std::map<std::uint8_t, SheetEntry> subs;  ///< by sub-index; empty for a variable

  /// True for a variable or a domain: one entry without a section of its own.
  bool is_variable() const { return subs.empty(); }
};

/// The list of objects that an index belongs to.
SheetObject::Group group_of(unsigned index);

/// Name of a section of an EDS: `1018`, `1018sub1`.
std::string place_text(unsigned index);
/// Name of a section of an entry.
std::string place_text(unsigned index, unsigned sub);

/// True for the section of the node in its network. CiA 306 spells it `DeviceComissioning`; some
/// files spell it correctly.
bool is_commissioning(std::string_view section_name);

/// Reads hexadecimal digits without a prefix: the whole text, at most `digits_max` digits.
std::optional<unsigned> parse_hex(std::string_view text, std::size_t digits_max);

struct DataSheet {
  /// `FileInfo`, `DeviceInfo`, `DeviceComissioning` and similar sections, in order; keys as
  /// written.
  std::vector<IniSection> sections;
  std::map<std::uint16_t, SheetObject> objects;  ///< by index
  /// Dummy entries (0001h to 0007h) that RPDOs may map.
  std::map<std::uint16_t, bool> dummies;
  std::vector<std::string> comments;  ///< of the file, in order
  std::string xml;                    ///< the file, if it was an XDD or XDC
  bool configured = false;            ///< DCF or XDC: the sheet has values

  /// The entry at an address, or null.
  const SheetEntry* find(unsigned index, unsigned sub) const;
  /// The first section of this name, or null. Both spellings of `DeviceComissioning` are one.
  const IniSection* section(std::string_view name) const;
  /// Number of objects with an index from `first` to `last`.
  std::size_t count_objects(unsigned first, unsigned last) const;
  /// The value of a key of a section; empty if there is none.
  std::string_view text(std::string_view section_name, std::string_view key) const;
  /// Node-ID of a configured device; 0: not given.
  NodeId node_id() const;
  /// True if SDO may not read the entry but a TPDO of the sheet carries it, as 6001h of CiA 407.
  /// Linear in the number of mapped objects for an entry that SDO may not read.
  bool sends_unreadable(unsigned index, unsigned sub) const;
};

}  // namespace canvoy::formats
