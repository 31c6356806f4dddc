#include "canvoy/formats/xdd/xdd.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "canvoy/formats/encoding.hpp"
#include "canvoy/formats/xdd/xdd_parts.hpp"

namespace canvoy::formats {

namespace {

using namespace detail;

class XddReader {
 public:
  XddReader(std::string_view text, Findings& findings) : text_(text), findings_(findings) {}

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
    parameters_.emplace(document_);
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

  /// Elements come in order, so that each line is counted once.
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
      const std::string_view value =
          is_text ? element.text().get() : element.attribute(shared.attribute).value();
      // Versions in other places are texts of their manufacturers.
      const bool is_revision = std::string_view(shared.key) == "RevisionNumber";
      if (is_revision && !sheet_number(value)) continue;
      section(shared.section).add(shared.key, key_text(shared, value));
    }
    const pugi::xml_node rates = find_below(document_, "baudRate");
    for (const pugi::xml_node& rate : rates.children()) {
      if (local_name(rate) != "supportedBaudRate") continue;
      const std::string_view text = rate.attribute("value").value();
      section("DeviceInfo").add(fmt::format("BaudRate_{}", text.substr(0, text.find(' '))), "1");
    }
    // An EDS states for each of them whether it is supported.
    for (const unsigned rate : {10U, 20U, 50U, 125U, 250U, 500U, 800U, 1000U}) {
      const std::string key = fmt::format("BaudRate_{}", rate);
      if (rates && section("DeviceInfo").find(key) == nullptr) section("DeviceInfo").add(key, "0");
    }
    sheet_.configured = static_cast<bool>(find_below(document_, "deviceCommissioning"));
  }

  void read_dummies() {
    for (const pugi::xml_node& dummy : find_below(document_, "dummyUsage").children()) {
      constexpr std::string_view word = "Dummy";
      const std::string_view text = dummy.attribute("entry").value();
      const std::size_t equals = text.find('=');
      if (!text.starts_with(word) || equals == std::string_view::npos) continue;
      const auto index = parse_hex(text.substr(word.size(), equals - word.size()), 4);
      if (index) sheet_.dummies[static_cast<std::uint16_t>(*index)] = text.ends_with('1');
    }
  }

  SheetEntry read_entry(const pugi::xml_node& element) {
    SheetEntry entry = parameters_ ? parameters_->entry_of(element) : SheetEntry{};
    entry.line = line_at(element.offset_debug());
    sheet_.configured = sheet_.configured || !entry.value.empty();
    return entry;
  }

  void read_object(const pugi::xml_node& element) {
    const std::string_view text = element.attribute("index").value();
    const auto index = parse_xml_number(text);
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
    const auto sub = parse_xml_number(text);
    if (!sub || *sub > 0xFF) {
      return complain(element.offset_debug(), place_text(index),
                      fmt::format("subIndex is '{}'", text), "2 hexadecimal digits");
    }
    object.subs[static_cast<std::uint8_t>(*sub)] = read_entry(element);
  }

  std::string_view text_;
  Findings& findings_;
  pugi::xml_document document_;
  std::optional<XddParameters> parameters_;
  DataSheet sheet_;
  std::ptrdiff_t counted_ = 0;  ///< number of bytes with counted lines
  std::ptrdiff_t lines_ = 0;
};

/// The declaration says so as well.
std::string in_utf8(std::string text) {
  const std::size_t end = text.starts_with("<?xml") ? text.find("?>") : 0;
  constexpr std::string_view word = "encoding=";
  const std::size_t at = text.substr(0, end).find(word);
  if (at == std::string::npos || at + word.size() + 1 >= end) return text;
  const std::size_t first = at + word.size() + 1;
  const std::size_t last = text.find(text[first - 1], first);
  if (last < end) text.replace(first, last - first, "UTF-8");
  return text;
}

}  // namespace

bool is_xml(std::string_view text) {
  // Zeros between the characters of UTF-16.
  if (marked_encoding(text)) text.remove_prefix(text.starts_with("\xEF") ? 3 : 2);
  const std::size_t first = text.find_first_not_of(std::string_view(" \t\r\n\0", 5));
  return first != std::string_view::npos && text[first] == '<';
}

DataSheet read_xdd(std::string_view text, Findings& findings) {
  const DecodedText decoded = decode_text(text);
  if (decoded.encoding == TextEncoding::utf8) return XddReader(text, findings).read();
  if (!decoded.remark().empty()) {
    findings.push_back({0, "", std::string(decoded.remark()), "", Finding::Weight::warning});
  }
  return XddReader(in_utf8(decoded.text), findings).read();
}

}  // namespace canvoy::formats
