// What a data sheet says of a device, whatever its form: EDS and DCF (CiA 306), XDD and XDC
// (CiA 311). Values stay as they were written, so that nothing is lost on the way; sheet_number()
// reads them.
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

#include "canvoy/canopen/cob_id.hpp"
#include "canvoy/formats/eds/ini.hpp"
#include "canvoy/profiles/description.hpp"

namespace canvoy::formats {

/// Something that is not as it should be.
struct Finding {
  enum class Weight : std::uint8_t { error, warning };
  std::size_t line = 0;       ///< 0: of the file as a whole
  std::string section = {};   ///< `1018sub1`, or the path of an element
  std::string text = {};      ///< what is wrong
  std::string expected = {};  ///< what would be right; may be empty
  Weight weight = Weight::error;
};

/// A number in a data sheet, which may grow with the node-ID.
struct SheetNumber {
  /// Where it grows with the node-ID, all node-IDs can be added to it.
  std::int64_t number = 0;
  bool plus_node_id = false;
  bool is_pattern = false;  ///< it was above the greatest of 63 bits: `number` has its 64 bits

  std::int64_t at(std::uint8_t node_id) const { return plus_node_id ? number + node_id : number; }
  friend bool operator==(const SheetNumber&, const SheetNumber&) = default;
};
/// `0x1A`, `26`, `032` (octal), `-5`, `$NODEID+0x180`, `0x180+$NODEID`, in any case; nothing where
/// it is none of them, or of more than 64 bits.
std::optional<SheetNumber> sheet_number(std::string_view text);

struct KeyValue {
  std::string key;
  std::string value;

  friend bool operator==(const KeyValue&, const KeyValue&) = default;
};

/// What is said of one entry. Empty texts: nothing was said.
struct SheetEntry {
  std::string name = {};
  unsigned object_type = 7;  ///< VAR
  unsigned data_type = 0;    ///< its index in the dictionary
  std::string access = {};   ///< as in the file: ro, wo, rw, rwr, rww, const
  std::string default_value = {};
  std::string low_limit = {};
  std::string high_limit = {};
  bool pdo_mapping = false;
  std::string obj_flags = {};
  std::string value = {};  ///< of a configured device (DCF, XDC)
  std::string denotation = {};
  /// Keys that CiA 306 does not define, and comments, of which the key is empty.
  std::vector<KeyValue> others = {};
  std::size_t line = 0;
};

struct SaidAccess {
  Access by_sdo = Access::none;
  Access in_pdos = Access::none;  ///< those that may carry it where it can be mapped
};
/// What `access` stands for (CiA 306), in letters of any case; nothing where it is none.
std::optional<SaidAccess> said_access(const SheetEntry& entry);
/// By its access: rw, rwr, rww or wo.
bool is_writable(const SheetEntry& entry);

struct SheetObject {
  enum class Group : std::uint8_t { mandatory, optional, manufacturer, not_listed };
  Group group = Group::not_listed;
  SheetEntry own;  ///< name, object type, and all of a variable
  std::map<std::uint8_t, SheetEntry> subs;

  bool is_variable() const { return subs.empty(); }
};

/// The list that an object belongs to by its index.
SheetObject::Group group_of(unsigned index);

/// The names of the sections of an EDS: `1018`, `1018sub1`.
std::string place_text(unsigned index);
std::string place_text(unsigned index, unsigned sub);

/// Whether it is the section of the node in its network. CiA 306 spells it `DeviceComissioning`;
/// not everybody does.
bool is_commissioning(std::string_view section_name);

/// Hexadecimal digits without a prefix, all of the text and not more than `digits_max`.
std::optional<unsigned> parse_hex(std::string_view text, std::size_t digits_max);

struct DataSheet {
  /// `FileInfo`, `DeviceInfo`, `DeviceComissioning` and the like, in order; keys as written.
  std::vector<IniSection> sections;
  std::map<std::uint16_t, SheetObject> objects;
  /// Dummy entries (0001h to 0007h) that RPDOs may map.
  std::map<std::uint16_t, bool> dummies;
  std::vector<std::string> comments;
  std::string xml;          ///< the file, where it was an XDD or XDC
  bool configured = false;  ///< DCF or XDC: it has values

  /// The entry at an address, or null.
  const SheetEntry* find(unsigned index, unsigned sub) const;
  /// The first section of this name, or null. Both spellings of `DeviceComissioning` are one.
  const IniSection* section(std::string_view name) const;
  /// How many objects have an index from `first` to `last`.
  std::size_t count_objects(unsigned first, unsigned last) const;
  /// A key of a section; empty where there is none.
  std::string_view text(std::string_view section_name, std::string_view key) const;
  /// That of a configured device; 0: none is said.
  NodeId node_id() const;
};

}  // namespace canvoy::formats
