#include "canvoy/formats/xdd/xdd_writer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <sstream>

#include "canvoy/formats/plain_text.hpp"
#include "canvoy/formats/terms.hpp"
#include "canvoy/formats/xdd/xdd_parts.hpp"

namespace canvoy::formats {

namespace {

using namespace detail;

/// `06-30-2026` in an EDS is `2026-06-30` in XML; the schema requires a date.
std::string xml_date(std::string_view date) {
  constexpr std::string_view unknown = "1970-01-01";
  constexpr std::string_view form = "dd-dd-dddd";
  const auto fits = [](char have, char want) {
    return want == 'd' ? have >= '0' && have <= '9' : have == want;
  };
  if (!std::ranges::equal(date, form, fits)) return std::string(unknown);
  return fmt::format("{}-{}-{}", date.substr(6), date.substr(0, 2), date.substr(3, 2));
}

/// The value of PDOmapping. Entries for one direction only have no access of their own here.
const char* mapping_text(const SheetEntry& entry) {
  if (!entry.pdo_mapping) return "no";
  if (same_letters(entry.access, "rwr")) return "TPDO";
  return same_letters(entry.access, "rww") ? "RPDO" : "optional";
}

/// Texts of an EDS are ASCII, or of an undeclared code page; XML needs UTF-8.
std::string utf8(std::string_view text) {
  return plain_text(text);
}

class XddWriter {
 public:
  explicit XddWriter(const DataSheet& sheet) : sheet_(sheet) {}

  std::string write() {
    constexpr unsigned all = pugi::parse_full | pugi::parse_ws_pcdata;
    const bool is_there = !sheet_.xml.empty() && document_.load_string(sheet_.xml.c_str(), all);
    if (!is_there) make_frame();
    parameters_.emplace(document_);
    write_commissioning();
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
    if (value.empty()) {
      element.remove_attribute(attribute);
      return;
    }
    if (!attribute) attribute = element.append_attribute(name);
    attribute.set_value(value.c_str());
  }

  pugi::xml_node add_profile(pugi::xml_node container, const char* title, const char* class_id,
                             const char* body_type) const {
    pugi::xml_node profile = container.append_child("co:ISO15745Profile");
    pugi::xml_node header = profile.append_child("ProfileHeader");
    header.append_child("ProfileIdentification").text() = title;
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
    body.append_attribute("fileName") = utf8(sheet_.text("FileInfo", "FileName")).c_str();
    body.append_attribute("fileCreator") = utf8(sheet_.text("FileInfo", "CreatedBy")).c_str();
    body.append_attribute("fileCreationDate") =
        xml_date(sheet_.text("FileInfo", "CreationDate")).c_str();
    body.append_attribute("fileVersion") = utf8(sheet_.text("FileInfo", "FileVersion")).c_str();
    return body;
  }

  /// Makes the elements around the objects.
  void make_frame() {
    document_.reset();
    pugi::xml_node declaration = document_.append_child(pugi::node_declaration);
    declaration.append_attribute("version") = "1.0";
    declaration.append_attribute("encoding") = "utf-8";
    pugi::xml_node container = document_.append_child("co:ISO15745ProfileContainer");
    container.append_attribute("xmlns:co") = "http://www.canopen.org/xml/1.1";
    container.append_attribute("xmlns:xsi") = "http://www.w3.org/2001/XMLSchema-instance";
    fill_device(add_profile(container, "CANopen device profile", "Device",
                            "co:ProfileBody_Device_CANopen"));
    fill_network(add_profile(container, "CANopen communication network profile",
                             "CommunicationNetwork",
                             "co:ProfileBody_CommunicationNetwork_CANopen"));
  }

  void fill_device(pugi::xml_node body) const {
    pugi::xml_node identity = body.append_child("co:DeviceIdentity");
    for (const char* name : {"co:vendorName", "co:vendorID", "co:productName", "co:productID"}) {
      identity.append_child(name);
    }
    if (!sheet_.text("DeviceInfo", "OrderCode").empty()) identity.append_child("co:orderNumber");
    // CiA 311 has no counterpart for the revision number of 1018h:03h.
    if (!sheet_.text("DeviceInfo", "RevisionNumber").empty()) {
      identity.append_child("co:version").append_attribute("versionType") = "FW";
    }
    pugi::xml_node characteristic = body.append_child("co:DeviceFunction")
                                        .append_child("co:capabilities")
                                        .append_child("co:characteristicsList")
                                        .append_child("co:characteristic");
    const std::string_view description = sheet_.text("FileInfo", "Description");
    const std::string_view product = sheet_.text("DeviceInfo", "ProductName");
    add_label(characteristic.append_child("co:characteristicName"), "Description");
    add_label(characteristic.append_child("co:characteristicContent"),
              utf8(description.empty() ? product : description));
  }

  static void add_label(pugi::xml_node parent, const std::string& text) {
    pugi::xml_node label = parent.append_child("label");
    label.append_attribute("lang") = "en";
    label.text() = text.c_str();
  }

  void fill_network(pugi::xml_node body) const {
    pugi::xml_node layers = body.append_child("ApplicationLayers");
    layers.append_child("co:CANopenObjectList");
    if (!sheet_.dummies.empty()) {
      pugi::xml_node dummies = layers.append_child("dummyUsage");
      for (const auto& [index, used] : sheet_.dummies) {
        constexpr std::uint16_t last = 7;  // the last one in the schema
        if (index == 0 || index > last) continue;
        dummies.append_child("dummy").append_attribute("entry") =
            fmt::format("Dummy{:04X}={}", index, used ? 1 : 0).c_str();
      }
    }
    pugi::xml_node rates =
        body.append_child("TransportLayers").append_child("PhysicalLayer").append_child("baudRate");
    for (const unsigned rate : {10U, 20U, 50U, 100U, 125U, 250U, 500U, 800U, 1000U}) {
      if (sheet_.text("DeviceInfo", fmt::format("BaudRate_{}", rate)) != "1") continue;
      rates.append_child("supportedBaudRate").append_attribute("value") =
          fmt::format("{} Kbps", rate).c_str();
    }
    pugi::xml_node management = body.append_child("NetworkManagement");
    management.append_child("CANopenGeneralFeatures").append_attribute("granularity") = "0";
    management.append_child("CANopenMasterFeatures");
  }

  /// An XDC names its node, an XDD does not.
  void write_commissioning() {
    const pugi::xml_node found = find_below(document_, "deviceCommissioning");
    const pugi::xml_node management = find_below(document_, "NetworkManagement");
    if (!sheet_.configured) {
      found.parent().remove_child(found);
      remove_actual_values();
    } else if (!found && management && sheet_.section("DeviceComissioning") != nullptr) {
      pugi::xml_node made = pugi::xml_node(management).append_child("deviceCommissioning");
      // The schema requires all of them.
      for (const SharedKey& shared : shared_keys) {
        if (std::string_view(shared.element) != "deviceCommissioning") continue;
        made.append_attribute(shared.attribute) = xml_text(shared, "").c_str();
      }
    }
  }

  /// Removes those of parameters that objects refer to.
  void remove_actual_values() {
    const pugi::xml_node process = find_below(document_, "ApplicationProcess");
    while (const pugi::xml_node value = find_below(process, "actualValue")) {
      value.parent().remove_child(value);
    }
  }

  void write_keys() {
    for (const SharedKey& shared : shared_keys) {
      pugi::xml_node element = find_below(document_, shared.element);
      const std::string_view value = sheet_.text(shared.section, shared.key);
      if (!element) continue;
      const std::string_view present = shared.attribute == nullptr
                                           ? element.text().get()
                                           : element.attribute(shared.attribute).value();
      if (key_text(shared, present) == value || value.empty()) continue;
      const std::string text = xml_text(shared, utf8(value));
      if (shared.attribute == nullptr) {
        element.text().set(text.c_str());
      } else {
        set(element, shared.attribute, text);
      }
    }
  }

  void write_objects() {
    const pugi::xml_node list = find_below(document_, "CANopenObjectList");
    if (!list) return;
    const auto is_kept = [this](unsigned index) {
      return index <= 0xFFFF && sheet_.objects.contains(static_cast<std::uint16_t>(index));
    };
    Elements elements = elements_of(list, "CANopenObject", "index", is_kept);
    for (const auto& [index, object] : sheet_.objects) {
      write_object(place_for(list, elements, index, "CANopenObject", "index", 4), object);
    }
  }

  using Elements = std::map<unsigned, pugi::xml_node>;

  /// Elements with this name, by number; removes those that are not kept.
  template <class Keep>
  static Elements elements_of(pugi::xml_node parent, std::string_view name, const char* attribute,
                              const Keep& is_kept) {
    Elements elements;
    for (pugi::xml_node element = parent.first_child(); element;) {
      const pugi::xml_node next = element.next_sibling();
      if (local_name(element) == name) {
        const auto number = parse_xml_number(element.attribute(attribute).value());
        if (!number || !is_kept(*number)) {
          parent.remove_child(element);
        } else {
          elements.try_emplace(*number, element);
        }
      }
      element = next;
    }
    return elements;
  }

  /// The element with this number, made if there is none.
  static pugi::xml_node place_for(pugi::xml_node parent, Elements& elements, unsigned number,
                                  const char* name, const char* attribute, unsigned digits) {
    const auto found = elements.find(number);
    if (found != elements.end()) return found->second;
    // With the same prefix as the others.
    const std::string made_name = elements.empty() ? name : elements.begin()->second.name();
    pugi::xml_node made = parent.append_child(made_name.c_str());
    made.append_attribute(attribute) = fmt::format("{:0{}X}", number, digits).c_str();
    return made;
  }

  void write_object(pugi::xml_node element, const SheetObject& object) const {
    write_entry(element, object.own);
    const auto is_kept = [&object](unsigned sub) {
      return sub <= 0xFF && object.subs.contains(static_cast<std::uint8_t>(sub));
    };
    Elements elements = elements_of(element, "CANopenSubObject", "subIndex", is_kept);
    if (object.is_variable()) return;
    set(element, "subNumber", fmt::format("{}", object.subs.size()));
    for (const auto& [sub, entry] : object.subs) {
      write_entry(place_for(element, elements, sub, "CANopenSubObject", "subIndex", 2), entry);
    }
  }

  /// What the file states already, in the element or in a parameter, is kept.
  void write_entry(pugi::xml_node element, const SheetEntry& entry) const {
    const SheetEntry present = parameters_->entry_of(element);
    if (!element.attribute("objectType") || present.object_type != entry.object_type) {
      set(element, "objectType", fmt::format("{}", entry.object_type));
    }
    if (present.data_type != entry.data_type) {
      set(element, "dataType", fmt::format("{:04X}", entry.data_type));
    }
    for (const SharedText& shared : shared_texts) {
      const bool is_left_out = shared.member == &SheetEntry::value && !sheet_.configured;
      const std::string text = is_left_out ? std::string() : entry.*shared.member;
      if (present.*shared.member != text) set(element, shared.attribute, utf8(text));
    }
    // The schema requires a name.
    if (!element.attribute("name")) element.append_attribute("name") = utf8(entry.name).c_str();
    write_access(element, entry, present);
    const auto flags = sheet_number(entry.obj_flags);
    if (flags && entry.obj_flags != present.obj_flags) {
      set(element, "objFlags", fmt::format("{:04X}", static_cast<std::uint16_t>(flags->number)));
    }
  }

  static void write_access(pugi::xml_node element, const SheetEntry& entry,
                           const SheetEntry& present) {
    if (same_letters(present.access, entry.access) && present.pdo_mapping == entry.pdo_mapping)
      return;
    const auto said = said_access(entry);
    set(element, "accessType", said ? std::string(access_name(said->by_sdo)) : entry.access);
    set(element, "PDOmapping", mapping_text(entry));
  }

  const DataSheet& sheet_;
  pugi::xml_document document_;
  std::optional<XddParameters> parameters_;
};

}  // namespace

std::string write_xdd(const DataSheet& sheet) {
  return XddWriter(sheet).write();
}

}  // namespace canvoy::formats
