// Common parts of reading and writing XDD files: the keys of an EDS that exist in XML, and an
// object from its element or from the parameter that it refers to.
#pragma once

#include <array>
#include <map>
#include <optional>
#include <pugixml.hpp>
#include <string>
#include <string_view>

#include "canvoy/formats/eds/data_sheet.hpp"

namespace canvoy::formats::detail {

/// Name of an element without the prefix of its namespace.
std::string_view local_name(const pugi::xml_node& node);
/// The first element with this name below `node`, at any depth.
pugi::xml_node find_below(const pugi::xml_node& node, std::string_view name);
/// The first child with this name, with any prefix.
pugi::xml_node child_of(const pugi::xml_node& node, std::string_view name);
/// Reads hexadecimal digits, with or without a prefix.
std::optional<unsigned> parse_xml_number(std::string_view text);

/// A value that an element or attribute and a key of a section share.
struct SharedKey {
  enum class Kind : std::uint8_t { text, number, flag, rate };
  const char* element;
  const char* attribute;  ///< null: the text of the element itself
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

/// The value in the form of an EDS: `true` is 1, `125 Kbps` is 125.
std::string key_text(const SharedKey& shared, std::string_view xml);
/// The value in the form of XML: numbers are decimal, 1 is `true`.
std::string xml_text(const SharedKey& shared, std::string_view key);

/// An attribute of an object, and the matching text of a SheetEntry.
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

/// The parameters of an application process, which objects refer to by `uniqueIDRef`. They give
/// type, access, default and limits where the objects do not (CiA 311).
class XddParameters {
 public:
  /// The document must outlive this.
  explicit XddParameters(const pugi::xml_document& document);

  /// The entry of an object, from its element or else from its parameter.
  SheetEntry entry_of(const pugi::xml_node& element) const;

 private:
  pugi::xml_node find(std::string_view id) const;
  void fill(const pugi::xml_node& parameter, SheetEntry& entry, bool is_compound) const;
  unsigned type_of(const pugi::xml_node& element) const;

  std::map<std::string_view, pugi::xml_node> elements_;  ///< by uniqueID
};

}  // namespace canvoy::formats::detail
