// What a filter asks of the values in a frame: which object, and how much.
//
//     FilterValue value({.name = "temperature"});
//     value.compare(false, {FilterLiteral::above(40, {Unit::degree_celsius})});
//     value.holds(words.values);
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "canvoy/decoder/decoder.hpp"
#include "canvoy/profiles/physical.hpp"
#include "canvoy/tools/filter/filter_names.hpp"
#include "canvoy/tools/filter/filter_unit.hpp"

namespace canvoy::tools {

/// What a value is to be: a number between two, a raw one (`0x1F4`), or a word.
struct FilterLiteral {
  enum class Kind : std::uint8_t { number, raw, word };
  struct Bound {
    double number = 0;
    bool is_open = false;  ///< the bound itself is not in it
  };
  Kind kind = Kind::number;
  Bound low = {-std::numeric_limits<double>::infinity()};
  Bound high = {std::numeric_limits<double>::infinity()};
  std::optional<FilterUnit> unit = {};  ///< nothing: that of the value
  FilterRange raw = {};
  std::string word = {};
};

class FilterValue {
 public:
  /// All values of these objects.
  explicit FilterValue(FilterObject object) : object_(std::move(object)) {}
  /// Those that are one of the literals, or, `negated`, none of them.
  void compare(bool negated, std::vector<FilterLiteral> literals) {
    compares_ = true;
    negated_ = negated;
    literals_ = std::move(literals);
  }
  /// Codes (a mapping, a COB-ID) are called as the objects that they are about, and are no amounts:
  /// they are not looked at.
  void leave_out_codes() { leaves_out_codes_ = true; }

  /// Whether one of the values is as asked for. What is known of a description is kept: it must
  /// live as long as the filter.
  bool holds(std::span<const decoder::DecodedValue> values);

  /// Whether the objects are only named, and this entry is of them, whatever its value is.
  bool names(const decoder::DecodedValue& entry);

  const FilterObject& object() const { return object_; }
  bool compares() const { return compares_; }
  bool is_negated() const { return negated_; }
  const std::vector<FilterLiteral>& literals() const { return literals_; }

 private:
  /// The latest of each hash: which parts of an entry the object names.
  static constexpr std::size_t known_max = 256;
  struct Known {
    const Profile* profile = nullptr;
    const ObjectInfo* object = nullptr;
    bool has_entry = false;
    std::uint16_t index = 0;
    std::uint8_t sub = 0;
    bool is_looked_at = false;
    bool has_whole = false;
    std::vector<bool> has_field;
  };

  bool holds(const decoder::DecodedValue& value);
  const Known& known(const decoder::DecodedValue& value);
  void look(Known& known, const decoder::DecodedValue& value) const;
  bool has_number(const decoder::DecodedValue& value) const;
  bool holds(const decoder::DecodedValue& value, const Reading& reading) const;
  bool holds_unknown(const decoder::DecodedValue& value) const;
  bool is_word(const decoder::DecodedValue& value, const Reading* reading,
               const FilterLiteral& literal) const;

  FilterObject object_;
  bool compares_ = false;
  bool negated_ = false;
  bool leaves_out_codes_ = false;
  std::vector<FilterLiteral> literals_;
  std::vector<Known> known_ = std::vector<Known>(known_max);
};

}  // namespace canvoy::tools
