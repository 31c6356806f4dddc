// Thrift's compact protocol, in which Parquet writes what stands where: fields by number, each with
// its type; numbers as varints.
//
//     ThriftStruct page(bytes);
//     page.number(1, 0);
//     ThriftStruct header = page.begin(5);
//     header.end();
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace canvoy::formats {

/// A structure that is written; the bytes have to outlive it.
class ThriftStruct {
 public:
  /// Appends to `bytes`.
  explicit ThriftStruct(std::string& bytes) : bytes_(&bytes) {}

  /// Fields by ascending numbers, which differ by 15 at most.
  void number(unsigned field, std::int32_t value) {
    head(field, Type::i32);
    append_varint(*bytes_, zigzag(value));
  }
  /// The same with 64 bits.
  void long_number(unsigned field, std::int64_t value) {
    head(field, Type::i64);
    append_varint(*bytes_, zigzag(value));
  }
  /// True or false.
  void flag(unsigned field, bool value) { head(field, value ? Type::yes : Type::no); }
  /// Bytes with their count.
  void text(unsigned field, std::string_view value) {
    head(field, Type::binary);
    append_text(*bytes_, value);
  }
  /// A structure within this; end() it before the next field.
  ThriftStruct begin(unsigned field) {
    head(field, Type::structure);
    return ThriftStruct(*bytes_);
  }
  /// Of structures, texts or numbers, which follow one behind another.
  enum class Of : std::uint8_t { numbers = 5, texts = 8, structures = 12 };
  /// The head of a list of `count` items.
  void list(unsigned field, Of of, std::uint64_t count) {
    head(field, Type::list);
    const auto type = static_cast<unsigned>(of);
    if (count < 15) {
      *bytes_ += static_cast<char>(count << 4 | type);
      return;
    }
    *bytes_ += static_cast<char>(0xF0 | type);
    append_varint(*bytes_, count);
  }
  /// Of a list of numbers.
  void item(std::int32_t number) { append_varint(*bytes_, zigzag(number)); }
  /// Of a list of texts.
  void item(std::string_view text) { append_text(*bytes_, text); }
  void end() { *bytes_ += '\0'; }

  /// Seven bits a byte, the lowest first.
  static void append_varint(std::string& bytes, std::uint64_t value) {
    while (value > 0x7F) {
      bytes += static_cast<char>(value | 0x80);
      value >>= 7;
    }
    bytes += static_cast<char>(value);
  }

 private:
  enum class Type : std::uint8_t {
    yes = 1,
    no = 2,
    i32 = 5,
    i64 = 6,
    binary = 8,
    list = 9,
    structure = 12
  };

  static std::uint64_t zigzag(std::int64_t value) {
    return static_cast<std::uint64_t>(value) << 1 ^ static_cast<std::uint64_t>(value >> 63);
  }
  static void append_text(std::string& bytes, std::string_view text) {
    append_varint(bytes, text.size());
    bytes += text;
  }
  void head(unsigned field, Type type) {
    *bytes_ += static_cast<char>((field - last_) << 4 | static_cast<unsigned>(type));
    last_ = field;
  }

  std::string* bytes_;
  unsigned last_ = 0;
};

}  // namespace canvoy::formats
