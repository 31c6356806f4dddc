// Conditions on the values in a frame: object and amount.
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
#include "canvoy/profiles/model/physical.hpp"
#include "canvoy/tools/argument/filter_names.hpp"
#include "canvoy/tools/argument/unit_argument.hpp"

namespace canvoy::tools {

/// A value to compare with: a number between two bounds, a raw number (`0x1F4`), or a word.
struct FilterLiteral {
  enum class Kind : std::uint8_t { number, raw, word };
  struct Bound {
    double number = 0;
    bool is_open = false;  ///< the bound is excluded
  };
  Kind kind = Kind::number;
  Bound low = {-std::numeric_limits<double>::infinity()};
  Bound high = {std::numeric_limits<double>::infinity()};
  std::optional<FilterUnit> unit = {};  ///< nothing: the unit of the value
  FilterRange raw = {};
  std::string word = {};
};

class FilterValue {
 public:
  /// Matches all values of these objects.
  explicit FilterValue(FilterObject object) : object_(std::move(object)) {}
  /// Restricts to values that equal one of the literals or, if `negated`, none of them.
  void compare(bool negated, std::vector<FilterLiteral> literals) {
    compares_ = true;
    negated_ = negated;
    literals_ = std::move(literals);
  }
  /// Ignores codes (a mapping, a COB-ID): they have the name of the object that they refer to, and
  /// are no amounts.
  void leave_out_codes() { leaves_out_codes_ = true; }

  /// True if one of the values matches. Caches results by description, which must live as long as
  /// the filter.
  bool holds(std::span<const decoder::DecodedValue> values);

  /// True if the condition only names objects, and this entry is one of them, with any value.
  bool names(const decoder::DecodedValue& entry);

  const FilterObject& object() const { return object_; }
  bool compares() const { return compares_; }
  bool is_negated() const { return negated_; }
  const std::vector<FilterLiteral>& literals() const { return literals_; }

 private:
  /// Size of the cache by hash: the parts of an entry that the object names.
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
