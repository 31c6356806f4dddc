#include "canvoy/formats/xdd/xdd_parts.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace canvoy::formats::detail {

namespace {

/// The simple types of CiA 311 are those of IEC 61131-3.
struct SimpleType {
  std::string_view name;
  DataType type;
};
constexpr auto simple_types = std::to_array<SimpleType>({
    {"BOOL", DataType::boolean},
    {"CHAR", DataType::integer8},
    {"SINT", DataType::integer8},
    {"INT", DataType::integer16},
    {"DINT", DataType::integer32},
    {"LINT", DataType::integer64},
    {"BYTE", DataType::unsigned8},
    {"USINT", DataType::unsigned8},
    {"WORD", DataType::unsigned16},
    {"UINT", DataType::unsigned16},
    {"DWORD", DataType::unsigned32},
    {"UDINT", DataType::unsigned32},
    {"LWORD", DataType::unsigned64},
    {"ULINT", DataType::unsigned64},
    {"REAL", DataType::real32},
    {"LREAL", DataType::real64},
    {"STRING", DataType::visible_string},
    {"WSTRING", DataType::unicode_string},
    {"BITSTRING", DataType::octet_string},
});

struct NamedAccess {
  std::string_view parameter;
  const char* access;
};
constexpr auto accesses = std::to_array<NamedAccess>({
    {"const", "const"},
    {"read", "ro"},
    {"write", "wo"},
    {"readWrite", "rw"},
    {"readWriteInput", "rwr"},
    {"readWriteOutput", "rww"},
});

/// Access and mapping of an EDS are in two attributes: an entry for TPDOs only is `rwr`.
std::string access_with(std::string access, std::string_view mapping) {
  if (access != "rw") return access;
  if (mapping == "TPDO") return "rwr";
  return mapping == "RPDO" ? "rww" : access;
}

class Collector : public pugi::xml_tree_walker {
 public:
  explicit Collector(std::map<std::string_view, pugi::xml_node>& elements) : elements_(elements) {}

  bool for_each(pugi::xml_node& node) override {
    const pugi::xml_attribute id = node.attribute("uniqueID");
    if (id) elements_.emplace(id.value(), node);
    return true;
  }

 private:
  std::map<std::string_view, pugi::xml_node>& elements_;
};

void fill_text(std::string& to, std::string_view text) {
  if (to.empty()) to = text;
}

std::string_view value_of(const pugi::xml_node& parent, std::string_view name) {
  return child_of(parent, name).attribute("value").value();
}

}  // namespace

std::string_view local_name(const pugi::xml_node& node) {
  const std::string_view name = node.name();
  const std::size_t colon = name.find(':');
  return colon == std::string_view::npos ? name : name.substr(colon + 1);
}

pugi::xml_node find_below(const pugi::xml_node& node, std::string_view name) {
  return node.find_node([name](const pugi::xml_node& each) { return local_name(each) == name; });
}

pugi::xml_node child_of(const pugi::xml_node& node, std::string_view name) {
  return node.find_child([name](const pugi::xml_node& each) { return local_name(each) == name; });
}

std::optional<unsigned> parse_xml_number(std::string_view text) {
  if (text.starts_with("0x") || text.starts_with("0X")) text.remove_prefix(2);
  constexpr std::size_t digits_max = 8;
  return parse_hex(text, digits_max);
}

std::string key_text(const SharedKey& shared, std::string_view xml) {
  if (shared.kind == SharedKey::Kind::rate) return std::string(xml.substr(0, xml.find(' ')));
  if (xml == "true") return "1";
  if (xml == "false") return "0";
  return std::string(xml);
}

std::string xml_text(const SharedKey& shared, std::string_view key) {
  if (shared.kind == SharedKey::Kind::text) return std::string(key);
  const auto number = sheet_number(key);
  const std::int64_t value = number ? number->number : 0;
  if (shared.kind == SharedKey::Kind::flag) return value != 0 ? "true" : "false";
  return fmt::format("{}{}", value, shared.kind == SharedKey::Kind::rate ? " Kbps" : "");
}

XddParameters::XddParameters(const pugi::xml_document& document) {
  Collector collector(elements_);
  find_below(document, "ApplicationProcess").traverse(collector);
}

pugi::xml_node XddParameters::find(std::string_view id) const {
  const auto found = elements_.find(id);
  return found == elements_.end() ? pugi::xml_node() : found->second;
}

SheetEntry XddParameters::entry_of(const pugi::xml_node& element) const {
  SheetEntry entry;
  for (const SharedText& shared : shared_texts) {
    entry.*shared.member = element.attribute(shared.attribute).value();
  }
  entry.object_type = element.attribute("objectType").as_uint(7);
  entry.data_type = parse_xml_number(element.attribute("dataType").value()).value_or(0);
  const std::string_view mapping = element.attribute("PDOmapping").value();
  entry.pdo_mapping = !mapping.empty() && mapping != "no";
  const auto flags = parse_xml_number(element.attribute("objFlags").value());
  if (flags) entry.obj_flags = fmt::format("0x{:X}", *flags);
  entry.access = element.attribute("accessType").value();
  const bool is_compound =
      entry.object_type == 8 || entry.object_type == 9 || child_of(element, "CANopenSubObject");
  const pugi::xml_node parameter = find(element.attribute("uniqueIDRef").value());
  if (parameter) {
    fill(parameter, entry, is_compound);
    fill(find(parameter.attribute("templateIDRef").value()), entry, is_compound);
    // The default access is read (CiA 311).
    if (!is_compound) fill_text(entry.access, "ro");
  }
  entry.access = access_with(entry.access, mapping);
  return entry;
}

void XddParameters::fill(const pugi::xml_node& parameter, SheetEntry& entry,
                         bool is_compound) const {
  fill_text(entry.name, child_of(parameter, "label").text().get());
  fill_text(entry.denotation, child_of(child_of(parameter, "denotation"), "label").text().get());
  if (is_compound) return;
  const std::string_view access = parameter.attribute("access").value();
  const auto* named = std::ranges::find(accesses, access, &NamedAccess::parameter);
  if (named != accesses.end()) fill_text(entry.access, named->access);
  fill_text(entry.default_value, value_of(parameter, "defaultValue"));
  fill_text(entry.value, value_of(parameter, "actualValue"));
  const pugi::xml_node range = child_of(child_of(parameter, "allowedValues"), "range");
  fill_text(entry.low_limit, value_of(range, "minValue"));
  fill_text(entry.high_limit, value_of(range, "maxValue"));
  if (entry.data_type != 0) return;
  entry.data_type = type_of(parameter);
  // A BITSTRING without a default stands for a domain, which has no type of its own.
  const bool is_bits = entry.data_type == static_cast<unsigned>(DataType::octet_string);
  if (is_bits && entry.default_value.empty()) {
    entry.data_type = static_cast<unsigned>(DataType::domain);
  }
}

/// 0 if none is given.
unsigned XddParameters::type_of(const pugi::xml_node& element) const {
  constexpr unsigned steps_max = 8;  // a type may refer to itself
  pugi::xml_node place = element;
  for (unsigned step = 0; step < steps_max && place; ++step) {
    pugi::xml_node reference;
    for (const pugi::xml_node& child : place.children()) {
      const std::string_view name = local_name(child);
      const auto* simple = std::ranges::find(simple_types, name, &SimpleType::name);
      if (simple != simple_types.end()) return static_cast<unsigned>(simple->type);
      if (name == "dataTypeIDRef") reference = child;
    }
    place = reference ? find(reference.attribute("uniqueIDRef").value()) : pugi::xml_node();
  }
  return 0;
}

}  // namespace canvoy::formats::detail
