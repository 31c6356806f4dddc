#include "canvoy/formats/xdd.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <pugixml.hpp>
#include <sstream>

namespace canvoy::formats {

namespace {

/// The name of an element without the prefix of its namespace.
std::string_view local_name(const pugi::xml_node& node) {
  const std::string_view name = node.name();
  const std::size_t colon = name.find(':');
  return colon == std::string_view::npos ? name : name.substr(colon + 1);
}

/// The first element of this name below `node`, at any depth.
pugi::xml_node find_below(const pugi::xml_node& node, std::string_view name) {
  return node.find_node([name](const pugi::xml_node& each) { return local_name(each) == name; });
}

/// Hexadecimal digits, with a prefix or without.
std::optional<unsigned> parse_number(std::string_view text) {
  if (text.starts_with("0x") || text.starts_with("0X")) text.remove_prefix(2);
  return parse_hex(text, 8);
}

/// A value that an element or attribute and a key of a section share.
struct SharedKey {
  const char* element;
  const char* attribute;  ///< null: the text of the element
  const char* section;
  const char* key;
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
    {"CANopenGeneralFeatures", "granularity", "DeviceInfo", "Granularity"},
    {"CANopenGeneralFeatures", "nrOfRxPDO", "DeviceInfo", "NrOfRXPDO"},
    {"CANopenGeneralFeatures", "nrOfTxPDO", "DeviceInfo", "NrOfTXPDO"},
    {"CANopenGeneralFeatures", "bootUpSlave", "DeviceInfo", "SimpleBootUpSlave"},
    {"CANopenGeneralFeatures", "groupMessaging", "DeviceInfo", "GroupMessaging"},
    {"CANopenGeneralFeatures", "dynamicChannels", "DeviceInfo", "DynamicChannelsSupported"},
    {"CANopenGeneralFeatures", "layerSettingServiceSlave", "DeviceInfo", "LSS_Supported"},
    {"CANopenMasterFeatures", "bootUpMaster", "DeviceInfo", "SimpleBootUpMaster"},
    {"deviceCommissioning", "nodeID", "DeviceComissioning", "NodeID"},
    {"deviceCommissioning", "nodeName", "DeviceComissioning", "NodeName"},
    {"deviceCommissioning", "actualBaudRate", "DeviceComissioning", "Baudrate"},
    {"deviceCommissioning", "networkNumber", "DeviceComissioning", "NetNumber"},
    {"deviceCommissioning", "networkName", "DeviceComissioning", "NetworkName"},
    {"deviceCommissioning", "CANopenManager", "DeviceComissioning", "CANopenManager"},
});

/// An attribute of an object, and the text of a SheetEntry.
struct SharedText {
  const char* attribute;
  std::string SheetEntry::*member;
};
constexpr auto shared_texts = std::to_array<SharedText>({
    {"name", &SheetEntry::name},
    {"accessType", &SheetEntry::access},
    {"lowLimit", &SheetEntry::low_limit},
    {"highLimit", &SheetEntry::high_limit},
    {"defaultValue", &SheetEntry::default_value},
    {"actualValue", &SheetEntry::value},
    {"denotation", &SheetEntry::denotation},
    {"objFlags", &SheetEntry::obj_flags},
});

/// `true` and `false` are 1 and 0 in an EDS.
std::string flag_text(std::string_view text) {
  if (text == "true") return "1";
  if (text == "false") return "0";
  return std::string(text);
}

class Reader {
 public:
  Reader(std::string_view text, Findings& findings) : text_(text), findings_(findings) {}

  DataSheet read() {
    const pugi::xml_parse_result result = document_.load_buffer(text_.data(), text_.size());
    if (!result) {
      complain(result.offset, "", fmt::format("no XML: {}", result.description()));
      return {};
    }
    sheet_.xml = text_;
    const pugi::xml_node list = find_below(document_, "CANopenObjectList");
    if (!list) {
      complain(0, "", "there is no CANopenObjectList", "a profile of CiA 311");
      return std::move(sheet_);
    }
    read_keys();
    read_dummies();
    for (const pugi::xml_node& child : list.children()) {
      if (local_name(child) == "CANopenObject") read_object(child);
    }
    return std::move(sheet_);
  }

 private:
  void complain(std::ptrdiff_t offset, std::string place, std::string what,
                std::string expected = "") {
    findings_.push_back({line_at(offset), std::move(place), std::move(what), std::move(expected),
                         Finding::Weight::error});
  }

  /// Elements come in their order, so that each line is counted once.
  std::size_t line_at(std::ptrdiff_t offset) {
    const std::ptrdiff_t place = std::clamp<std::ptrdiff_t>(offset, 0, std::ssize(text_));
    if (place < counted_) counted_ = lines_ = 0;
    const auto* from = text_.data() + counted_;
    lines_ += std::count(from, text_.data() + place, '\n');
    counted_ = place;
    return static_cast<std::size_t>(lines_) + 1;
  }

  IniSection& section(const char* name) {
    const auto found = std::ranges::find(sheet_.sections, name, &IniSection::name);
    if (found != sheet_.sections.end()) return *found;
    sheet_.sections.push_back({name, 0, {}});
    return sheet_.sections.back();
  }

  void read_keys() {
    for (const SharedKey& shared : shared_keys) {
      const pugi::xml_node element = find_below(document_, shared.element);
      if (!element) continue;
      const bool is_text = shared.attribute == nullptr;
      if (!is_text && !element.attribute(shared.attribute)) continue;
      const std::string value =
          is_text ? element.text().get() : element.attribute(shared.attribute).value();
      section(shared.section).add(shared.key, flag_text(value));
    }
    const pugi::xml_node rates = find_below(document_, "baudRate");
    for (const pugi::xml_node& rate : rates.children()) {
      if (local_name(rate) != "supportedBaudRate") continue;
      const std::string_view text = rate.attribute("value").value();
      section("DeviceInfo").add(fmt::format("BaudRate_{}", text.substr(0, text.find(' '))), "1");
    }
    sheet_.configured = static_cast<bool>(find_below(document_, "deviceCommissioning"));
  }

  void read_dummies() {
    for (const pugi::xml_node& dummy : find_below(document_, "dummyUsage").children()) {
      constexpr std::string_view word = "Dummy";
      const std::string_view text = dummy.attribute("entry").value();
      const std::size_t equals = text.find('=');
      if (!text.starts_with(word) || equals == std::string_view::npos) continue;
      const auto index = parse_number(text.substr(word.size(), equals - word.size()));
      if (index) sheet_.dummies[static_cast<std::uint16_t>(*index)] = text.ends_with('1');
    }
  }

  SheetEntry read_entry(const pugi::xml_node& element) {
    SheetEntry entry;
    entry.line = line_at(element.offset_debug());
    for (const SharedText& shared : shared_texts) {
      entry.*shared.member = element.attribute(shared.attribute).value();
    }
    sheet_.configured = sheet_.configured || !entry.value.empty();
    entry.object_type = element.attribute("objectType").as_uint(7);
    entry.data_type = parse_number(element.attribute("dataType").value()).value_or(0);
    const std::string_view mapping = element.attribute("PDOmapping").value();
    entry.pdo_mapping = !mapping.empty() && mapping != "no";
    return entry;
  }

  void read_object(const pugi::xml_node& element) {
    const std::string_view text = element.attribute("index").value();
    const auto index = parse_number(text);
    if (!index || *index > 0xFFFF) {
      return complain(element.offset_debug(), "CANopenObject", fmt::format("index is '{}'", text),
                      "4 hexadecimal digits");
    }
    const auto [place, is_new] =
        sheet_.objects.try_emplace(static_cast<std::uint16_t>(*index), SheetObject());
    if (!is_new) {
      complain(element.offset_debug(), place_text(*index), "the object is there twice");
    }
    SheetObject& object = place->second;
    object.own = read_entry(element);
    object.group = group_of(*index);
    for (const pugi::xml_node& child : element.children()) {
      if (local_name(child) == "CANopenSubObject") read_sub(child, *index, object);
    }
  }

  void read_sub(const pugi::xml_node& element, unsigned index, SheetObject& object) {
    const std::string_view text = element.attribute("subIndex").value();
    const auto sub = parse_number(text);
    if (!sub || *sub > 0xFF) {
      return complain(element.offset_debug(), place_text(index),
                      fmt::format("subIndex is '{}'", text), "2 hexadecimal digits");
    }
    object.subs[static_cast<std::uint8_t>(*sub)] = read_entry(element);
  }

  std::string_view text_;
  Findings& findings_;
  pugi::xml_document document_;
  DataSheet sheet_;
  std::ptrdiff_t counted_ = 0;  ///< bytes in which the lines were counted
  std::ptrdiff_t lines_ = 0;
};

class Writer {
 public:
  explicit Writer(const DataSheet& sheet) : sheet_(sheet) {}

  std::string write() {
    constexpr unsigned all = pugi::parse_full | pugi::parse_ws_pcdata;
    const bool is_there = !sheet_.xml.empty() && document_.load_string(sheet_.xml.c_str(), all);
    if (!is_there) make_frame();
    write_keys();
    write_objects();
    std::ostringstream text;
    document_.save(text, "  ", is_there ? pugi::format_raw : pugi::format_default);
    return is_there ? with_line_ends(text.str()) : text.str();
  }

 private:
  /// The parser drops the blanks outside of the root element.
  static std::string with_line_ends(std::string text) {
    const std::size_t declaration = text.starts_with("<?xml") ? text.find("?>") : std::string::npos;
    if (declaration != std::string::npos) text.insert(declaration + 2, "\n");
    return text + '\n';
  }

  static void set(pugi::xml_node element, const char* name, const std::string& value) {
    pugi::xml_attribute attribute = element.attribute(name);
    if (value.empty() && !attribute) return;
    if (!attribute) attribute = element.append_attribute(name);
    attribute.set_value(value.c_str());
  }

  static pugi::xml_node child(pugi::xml_node parent, const char* name) {
    const pugi::xml_node found = find_below(parent, name);
    return found ? found : parent.append_child(name);
  }

  static pugi::xml_node add_profile(pugi::xml_node container, const char* class_id,
                                    const char* body_type) {
    pugi::xml_node profile = container.append_child("ISO15745Profile");
    pugi::xml_node header = profile.append_child("ProfileHeader");
    header.append_child("ProfileIdentification").text() = "CANopen device profile";
    header.append_child("ProfileRevision").text() = "1.1";
    header.append_child("ProfileName");
    header.append_child("ProfileSource");
    header.append_child("ProfileClassID").text() = class_id;
    pugi::xml_node reference = header.append_child("ISO15745Reference");
    reference.append_child("ISO15745Part").text() = "1";
    reference.append_child("ISO15745Edition").text() = "1";
    reference.append_child("ProfileTechnology").text() = "CANopen";
    pugi::xml_node body = profile.append_child("ProfileBody");
    body.append_attribute("xsi:type") = body_type;
    return body;
  }

  /// All that there has to be around the objects.
  void make_frame() {
    document_.reset();
    pugi::xml_node declaration = document_.append_child(pugi::node_declaration);
    declaration.append_attribute("version") = "1.0";
    declaration.append_attribute("encoding") = "utf-8";
    pugi::xml_node container = document_.append_child("ISO15745ProfileContainer");
    container.append_attribute("xmlns") = "http://www.canopen.org/xml/1.0";
    container.append_attribute("xmlns:xsi") = "http://www.w3.org/2001/XMLSchema-instance";
    pugi::xml_node device = add_profile(container, "Device", "ProfileBody_Device_CANopen");
    pugi::xml_node identity = device.append_child("DeviceIdentity");
    for (const char* name : {"vendorName", "vendorID", "productName", "productID", "orderNumber"}) {
      identity.append_child(name);
    }
    pugi::xml_node network =
        add_profile(container, "CommunicationNetwork", "ProfileBody_CommunicationNetwork_CANopen");
    set_date(device);
    set_date(network);
    pugi::xml_node layers = network.append_child("ApplicationLayers");
    layers.append_child("CANopenObjectList");
    pugi::xml_node dummies = layers.append_child("dummyUsage");
    for (const auto& [index, used] : sheet_.dummies) {
      dummies.append_child("dummy").append_attribute("entry") =
          fmt::format("Dummy{:04X}={}", index, used ? 1 : 0).c_str();
    }
    pugi::xml_node rates = network.append_child("TransportLayers")
                               .append_child("PhysicalLayer")
                               .append_child("baudRate");
    for (const unsigned rate : {10U, 20U, 50U, 125U, 250U, 500U, 800U, 1000U}) {
      if (sheet_.text("DeviceInfo", fmt::format("BaudRate_{}", rate)) != "1") continue;
      rates.append_child("supportedBaudRate").append_attribute("value") =
          fmt::format("{} Kbps", rate).c_str();
    }
    pugi::xml_node management = network.append_child("NetworkManagement");
    management.append_child("CANopenGeneralFeatures");
    management.append_child("CANopenMasterFeatures");
    if (sheet_.configured) management.append_child("deviceCommissioning");
  }

  /// `06-30-2026` in an EDS is `2026-06-30` here.
  void set_date(pugi::xml_node body) const {
    const std::string date(sheet_.text("FileInfo", "CreationDate"));
    set(body, "fileName", std::string(sheet_.text("FileInfo", "FileName")));
    set(body, "fileCreator", std::string(sheet_.text("FileInfo", "CreatedBy")));
    if (date.size() == 10) {
      set(body, "fileCreationDate",
          fmt::format("{}-{}-{}", date.substr(6), date.substr(0, 2), date.substr(3, 2)));
    }
    set(body, "fileVersion", std::string(sheet_.text("FileInfo", "FileVersion")));
  }

  void write_keys() {
    for (const SharedKey& shared : shared_keys) {
      pugi::xml_node element = find_below(document_, shared.element);
      const std::string value(sheet_.text(shared.section, shared.key));
      if (!element) continue;
      const std::string present = shared.attribute == nullptr
                                      ? element.text().get()
                                      : element.attribute(shared.attribute).value();
      if (flag_text(present) == value) continue;
      if (shared.attribute == nullptr) {
        element.text().set(value.c_str());
      } else {
        set(element, shared.attribute, value);
      }
    }
  }

  void write_objects() {
    pugi::xml_node list = find_below(document_, "CANopenObjectList");
    if (!list) return;
    for (pugi::xml_node element = list.first_child(); element;) {
      const pugi::xml_node next = element.next_sibling();
      const auto index = parse_number(element.attribute("index").value());
      const bool is_object = local_name(element) == "CANopenObject";
      if (is_object && (!index || !sheet_.objects.contains(static_cast<std::uint16_t>(*index)))) {
        list.remove_child(element);
      }
      element = next;
    }
    for (const auto& [index, object] : sheet_.objects) write_object(list, index, object);
  }

  static pugi::xml_node element_of(pugi::xml_node parent, const char* name, const char* attribute,
                                   unsigned number, unsigned digits) {
    for (const pugi::xml_node& child : parent.children()) {
      if (local_name(child) == name && parse_number(child.attribute(attribute).value()) == number) {
        return child;
      }
    }
    pugi::xml_node made = parent.append_child(name);
    made.append_attribute(attribute) = fmt::format("{:0{}X}", number, digits).c_str();
    return made;
  }

  static void write_object(pugi::xml_node list, unsigned index, const SheetObject& object) {
    pugi::xml_node element = element_of(list, "CANopenObject", "index", index, 4);
    write_entry(element, object.own);
    if (object.is_variable()) return;
    set(element, "subNumber", fmt::format("{}", object.subs.size()));
    for (const auto& [sub, entry] : object.subs) {
      write_entry(element_of(element, "CANopenSubObject", "subIndex", sub, 2), entry);
    }
  }

  static void write_entry(pugi::xml_node element, const SheetEntry& entry) {
    for (const SharedText& shared : shared_texts) {
      const bool is_access = shared.member == &SheetEntry::access;
      const std::string& text = entry.*shared.member;
      // The directions of PDOs that an EDS puts into the access are values of PDOmapping here.
      set(element, shared.attribute, is_access && (text == "rwr" || text == "rww") ? "rw" : text);
    }
    set(element, "objectType", fmt::format("{}", entry.object_type));
    if (parse_number(element.attribute("dataType").value()).value_or(0) != entry.data_type) {
      set(element, "dataType", fmt::format("{:04X}", entry.data_type));
    }
    const std::string_view mapping = element.attribute("PDOmapping").value();
    const bool is_mapped = !mapping.empty() && mapping != "no";
    if (is_mapped != entry.pdo_mapping) {
      set(element, "PDOmapping", entry.pdo_mapping ? "optional" : "no");
    }
  }

  const DataSheet& sheet_;
  pugi::xml_document document_;
};

}  // namespace

bool is_xml(std::string_view text) {
  if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
  const std::size_t first = text.find_first_not_of(" \t\r\n");
  return first != std::string_view::npos && text[first] == '<';
}

DataSheet read_xdd(std::string_view text, Findings& findings) {
  return Reader(text, findings).read();
}

std::string write_xdd(const DataSheet& sheet) {
  return Writer(sheet).write();
}

}  // namespace canvoy::formats
