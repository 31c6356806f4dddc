#include "canvoy/formats/sheet/sheet_agreement.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "canvoy/canopen/dictionary/object_index.hpp"
#include "canvoy/profiles/model/mapping_value.hpp"

namespace canvoy::formats {

namespace {

/// A key of DeviceInfo that repeats an entry of 1018h.
struct IdentityKey {
  std::string_view key;
  unsigned sub;
};
constexpr auto identity_keys =
    std::to_array<IdentityKey>({{"VendorNumber", 1}, {"ProductNumber", 2}, {"RevisionNumber", 3}});

bool is_ascii(std::string_view text) {
  return std::ranges::all_of(text, [](char c) { return static_cast<unsigned char>(c) < 0x80; });
}

/// True if SDO can write an entry of the mapping of a PDO.
bool can_change_mapping(const DataSheet& sheet) {
  return std::ranges::any_of(sheet.objects, [](const auto& each) {
    if (!is_pdo_mapping(each.first)) return false;
    return std::ranges::any_of(each.second.subs, [](const auto& sub) {
      return sub.first != 0 && is_writable(sub.second);
    });
  });
}

class AgreementChecker {
 public:
  AgreementChecker(const DataSheet& sheet, Findings& findings)
      : sheet_(sheet), findings_(findings), device_(sheet.section("DeviceInfo")) {}

  void check() {
    if (device_ != nullptr) {
      for (const IdentityKey& each : identity_keys) check_identity(each);
      check_lss();
      check_granularity();
      check_bit_rate();
    }
    // XML declares its own encoding.
    if (sheet_.xml.empty()) check_characters();
  }

 private:
  void warn(const IniLine& line, std::string_view section, std::string expected) {
    findings_.push_back({line.number, std::string(section),
                         fmt::format("{} is {}", line.key, line.value), std::move(expected),
                         Finding::Weight::warning});
  }

  /// A number of DeviceInfo; nothing if there is none.
  std::optional<std::int64_t> number(const IniLine* line) const {
    const auto found = line == nullptr ? std::nullopt : sheet_number(line->value);
    return found ? std::optional(found->number) : std::nullopt;
  }

  /// A device may have its identity in memory only: 0 means no statement.
  void check_identity(const IdentityKey& each) {
    const IniLine* line = device_->find(each.key);
    const SheetEntry* entry = sheet_.find(object_index::identity, each.sub);
    const auto said = number(line);
    const auto held = entry == nullptr ? std::nullopt : sheet_number(entry->default_value);
    if (!said || !held || held->number == 0 || held->number == *said) return;
    warn(*line, device_->name,
         fmt::format("{}, as {} has", entry->default_value,
                     place_text(object_index::identity, each.sub)));
  }

  /// The four entries of 1018h are the LSS address (CiA 305).
  void check_lss() {
    const IniLine* line = device_->find("LSS_Supported");
    if (number(line).value_or(0) == 0) return;
    constexpr unsigned parts = 4;
    for (unsigned sub = 1; sub <= parts; ++sub) {
      if (sheet_.find(object_index::identity, sub) != nullptr) continue;
      return warn(*line, device_->name,
                  fmt::format("0, or {}: the LSS address is all of 1018h",
                              place_text(object_index::identity, sub)));
    }
  }

  void check_granularity() {
    const IniLine* line = device_->find("Granularity");
    const auto said = number(line);
    if (!said || (*said != 0) == can_change_mapping(sheet_)) return;
    warn(*line, device_->name,
         *said != 0 ? "0, as no mapping of a PDO can be written"
                    : "1 to 64 bits, as the mapping of PDOs can be written");
  }

  void check_bit_rate() {
    for (const IniSection& node : sheet_.sections) {
      const IniLine* line = is_commissioning(node.name) ? node.find("Baudrate") : nullptr;
      const auto rate = number(line);
      if (!rate) continue;
      const auto supported = device_->value(fmt::format("BaudRate_{}", *rate));
      if (supported && *supported != "0") continue;
      warn(*line, node.name, fmt::format("a rate that DeviceInfo has, BaudRate_{}=1", *rate));
    }
  }

  /// One warning for all: a text with one such character usually has many.
  void check_characters() {
    for (const IniSection& section : sheet_.sections) {
      for (const IniLine& line : section.lines) look_at(line.number, section.name, line.value);
    }
    for (const auto& [index, object] : sheet_.objects) {
      look_at(object.own.line, place_text(index), object.own.name);
      for (const auto& [sub, entry] : object.subs) {
        look_at(entry.line, place_text(index, sub), entry.name);
      }
    }
    if (strange_ == 0) return;
    first_.text +=
        strange_ == 1 ? " is not ASCII" : fmt::format(" and {} more are not ASCII", strange_ - 1);
    first_.expected = "ASCII (CiA 306)";
    first_.weight = Finding::Weight::warning;
    findings_.push_back(first_);
  }

  void look_at(std::size_t line, std::string place, const std::string& text) {
    if (is_ascii(text)) return;
    if (strange_++ == 0) {
      first_.line = line;
      first_.section = std::move(place);
      first_.text = fmt::format("'{}'", text);
    }
  }

  const DataSheet& sheet_;
  Findings& findings_;
  const IniSection* device_;
  std::size_t strange_ = 0;  ///< texts that are not ASCII
  Finding first_;            ///< the first of them
};

}  // namespace

void make_agree(DataSheet& sheet) {
  const auto device = std::ranges::find_if(sheet.sections, [](const IniSection& section) {
    return same_letters(section.name, "DeviceInfo");
  });
  if (device == sheet.sections.end()) return;
  const auto set = [&device](std::string_view key, const std::string& value) {
    for (IniLine& line : device->lines) {
      if (same_letters(line.key, key)) line.value = value;
    }
  };
  for (const IdentityKey& each : identity_keys) {
    const SheetEntry* entry = sheet.find(object_index::identity, each.sub);
    const auto held = entry == nullptr ? std::nullopt : sheet_number(entry->default_value);
    if (!held || held->number == 0) continue;
    set(each.key, fmt::format("0x{:08X}", static_cast<std::uint32_t>(held->number)));
  }
  const auto granularity = sheet_number(device->value("Granularity").value_or(""));
  const bool can_change = can_change_mapping(sheet);
  if (granularity && (granularity->number != 0) != can_change) {
    set("Granularity", can_change ? "1" : "0");
  }
  set("NrOfRXPDO", fmt::format("{}", sheet.count_objects(object_index::rpdo_parameter,
                                                         object_index::rpdo_parameter_last)));
  set("NrOfTXPDO", fmt::format("{}", sheet.count_objects(object_index::tpdo_parameter,
                                                         object_index::tpdo_parameter_last)));
}

void check_agreement(const DataSheet& sheet, Findings& findings) {
  AgreementChecker(sheet, findings).check();
}

}  // namespace canvoy::formats
