#include "canvoy/text/frame_json.hpp"

#include "canvoy/formats/plain_text.hpp"
#include "canvoy/formats/terms.hpp"
#include "canvoy/text/json_line.hpp"
#include "canvoy/text/object_words.hpp"
#include "canvoy/text/value_text.hpp"

namespace canvoy::text {

namespace {

using decoder::DecodedValue;

void append_marks(JsonLine& json, decoder::Marks marks) {
  json.key("marks").begin_list();
  for (const decoder::Mark mark : decoder::all_marks) {
    if (marks.has(mark)) json.text(decoder::mark_name(mark));
  }
  json.end_list();
}

}  // namespace

void FrameJson::append(std::string& line, Duration time, std::string_view bus,
                       std::string_view frame, const FrameWords& words, std::string_view text) {
  constexpr unsigned places_of_microseconds = 6;
  JsonLine json(line);
  line += "{\"time\":";
  json.decimal(time.count(), places_of_microseconds);
  line += named_bus(bus);
  // Frames and services need no escapes.
  line.append(frame).append(R"(","service":")").append(words.service).append("\"");
  if (words.node != 0) json.key("node").number(words.node);
  if (words.client != 0) json.key("client").number(words.client);
  if (words.kept == nullptr) {
    append_said(line, words, text);
  } else {
    if (words.kept->empty()) append_said(*words.kept, words, text);
    json.written(*words.kept);
  }
  if (!words.marks.empty()) append_marks(json, words.marks);
  if (!words.news.empty()) json.key("news").text(words.news);
  line += '}';
}

const std::string& FrameJson::named_bus(std::string_view bus) {
  if (!bus_text_.empty() && bus_ == bus) return bus_text_;
  bus_ = bus;
  // The comma after the time.
  bus_text_ = "0";
  JsonLine(bus_text_).key("bus").text(bus);
  bus_text_.erase(0, 1);
  bus_text_ += R"(,"frame":")";
  return bus_text_;
}

void FrameJson::append_said(std::string& line, const FrameWords& words, std::string_view text) {
  JsonLine json(line);
  if (!text.empty()) json.key("text").text(text);
  if (words.values.empty()) return;
  json.key("values");
  append_values(line, words.values);
}

void FrameJson::append_values(std::string& line, std::span<const DecodedValue> values) {
  JsonLine json(line);
  json.begin_list();
  for (const DecodedValue& value : values) append_value(line, value);
  json.end_list();
}

void FrameJson::append_value(std::string& line, const DecodedValue& value) {
  JsonLine json(line);
  json.begin_object();
  json.written(name_of(value));
  json.key("raw").hex(value.bytes());
  line += ",\"value\":";
  values_.append(line, value);
  const bool has_unit = value.entry != nullptr && value.entry->value.unit != Unit::none;
  // The symbols of units are UTF-8, and need no escapes.
  if (has_unit) line.append(R"(,"unit":")").append(symbol(value.entry->value.unit)).append("\"");
  if (!value.marks.empty()) append_marks(json, value.marks);
  line += '}';
}

const std::string& FrameJson::name_of(const DecodedValue& value) {
  constexpr unsigned subs = 8;  // neighbours get slots of their own
  const auto place = reinterpret_cast<std::uintptr_t>(value.profile) / alignof(Profile);
  Name& known = names_[(value.index * subs + value.sub + place) % names_max];
  const bool has_entry = value.entry != nullptr;
  if (!known.text.empty() && known.profile == value.profile && known.object == value.object &&
      known.has_entry == has_entry && known.index == value.index && known.sub == value.sub) {
    return known.text;
  }
  known = {value.profile, value.object, has_entry, value.index, value.sub, {}};
  JsonLine json(known.text);
  json.key("index").text(formats::hex(value.index, 4));
  json.key("sub").text(formats::hex(value.sub, 2));
  if (value.object != nullptr) json.key("name").text(object_name_text(value));
  return known.text;
}

}  // namespace canvoy::text
