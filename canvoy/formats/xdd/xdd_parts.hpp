// What reading and writing of XDD files share: the keys of an EDS that have a place in XML, and how
// an object is read from its element, or from the parameter that it refers to.
#pragma once

#include <array>
#include <map>
#include <optional>
#include <pugixml.hpp>
#include <string>
#include <string_view>

#include "canvoy/formats/sheet/data_sheet.hpp"

namespace canvoy::formats::detail {

/// The name of an element without the prefix of its namespace.
std::string_view local_name(const pugi::xml_node& node);
/// The first element of this name below `node`, at any depth.
pugi::xml_node find_below(const pugi::xml_node& node, std::string_view name);
/// The first child of this name, whatever its prefix.
pugi::xml_node child_of(const pugi::xml_node& node, std::string_view name);
/// Hexadecimal digits, with a prefix or without.
std::optional<unsigned> parse_xml_number(std::string_view text);

/// A value that an element or attribute and a key of a section share.
struct SharedKey {
  enum class Kind : std::uint8_t { text, number, flag, rate };
  const char* element;
  const char* attribute;  ///< null: the text of the element
  const char* section;
  const char* key;
  Kind kind = Kind::text;
};
constexpr auto shared_keys = std::to_array<SharedKey>({
    {"ProfileBody", "fileName", "FileInfo", "FileName"},
    {"ProfileBody", "fileVersion", "FileInfo", "FileVersion"},
    {"ProfileBody", "fileCreator", "FileInfo", "CreatedBy"},
    {"vendorName", nullptr, "DeviceInfo", "VendorName"},
    {"vendorID", nullptr, "DeviceInfo", "VendorNumber"},
    {"productName", nullptr, "DeviceInfo", "ProductName"},
    {"productID", nullptr, "DeviceInfo", "ProductNumber"},
    {"orderNumber", nullptr, "DeviceInfo", "OrderCode"},
    {"version", nullptr, "DeviceInfo", "RevisionNumber"},
    {"CANopenGeneralFeatures", "granularity", "DeviceInfo", "Granularity", SharedKey::Kind::number},
    {"CANopenGeneralFeatures", "nrOfRxPDO", "DeviceInfo", "NrOfRXPDO", SharedKey::Kind::number},
    {"CANopenGeneralFeatures", "nrOfTxPDO", "DeviceInfo", "NrOfTXPDO", SharedKey::Kind::number},
    {"CANopenGeneralFeatures", "bootUpSlave", "DeviceInfo", "SimpleBootUpSlave",
     SharedKey::Kind::flag},
    {"CANopenGeneralFeatures", "groupMessaging", "DeviceInfo", "GroupMessaging",
     SharedKey::Kind::flag},
    {"CANopenGeneralFeatures", "dynamicChannels", "DeviceInfo", "DynamicChannelsSupported",
     SharedKey::Kind::number},
    {"CANopenGeneralFeatures", "layerSettingServiceSlave", "DeviceInfo", "LSS_Supported",
     SharedKey::Kind::flag},
    {"CANopenMasterFeatures", "bootUpMaster", "DeviceInfo", "SimpleBootUpMaster",
     SharedKey::Kind::flag},
    {"deviceCommissioning", "nodeID", "DeviceComissioning", "NodeID", SharedKey::Kind::number},
    {"deviceCommissioning", "nodeName", "DeviceComissioning", "NodeName"},
    {"deviceCommissioning", "actualBaudRate", "DeviceComissioning", "Baudrate",
     SharedKey::Kind::rate},
    {"deviceCommissioning", "networkNumber", "DeviceComissioning", "NetNumber",
     SharedKey::Kind::number},
    {"deviceCommissioning", "networkName", "DeviceComissioning", "NetworkName"},
    {"deviceCommissioning", "CANopenManager", "DeviceComissioning", "CANopenManager",
     SharedKey::Kind::flag},
});

/// As the key of an EDS has it: `true` is 1, `125 Kbps` is 125.
std::string key_text(const SharedKey& shared, std::string_view xml);
/// As XML has it: a number is decimal, 1 is `true`.
std::string xml_text(const SharedKey& shared, std::string_view key);

/// An attribute of an object, and the text of a SheetEntry.
struct SharedText {
  const char* attribute;
  std::string SheetEntry::*member;
};
constexpr auto shared_texts = std::to_array<SharedText>({
    {"name", &SheetEntry::name},
    {"lowLimit", &SheetEntry::low_limit},
    {"highLimit", &SheetEntry::high_limit},
    {"defaultValue", &SheetEntry::default_value},
    {"actualValue", &SheetEntry::value},
    {"denotation", &SheetEntry::denotation},
});

/// The parameters of an application process (CiA 311), which objects refer to by `uniqueIDRef`:
/// there stand type, access, default and limits where the objects themselves do not say them.
class XddParameters {
 public:
  /// The document must outlive this.
  explicit XddParameters(const pugi::xml_document& document);

  /// What the element of an object says, and behind it its parameter.
  SheetEntry entry_of(const pugi::xml_node& element) const;

 private:
  pugi::xml_node find(std::string_view id) const;
  void fill(const pugi::xml_node& parameter, SheetEntry& entry, bool is_compound) const;
  unsigned type_of(const pugi::xml_node& element) const;

  std::map<std::string_view, pugi::xml_node> elements_;  ///< by their uniqueID
};

}  // namespace canvoy::formats::detail
