#include "canvoy/devices/cia447/gps/nmea.hpp"

namespace canvoy::cia447 {

namespace {

constexpr double knot = 1852.0 / 3600.0;

constexpr int hexadecimal(char digit) {
  if (digit >= '0' && digit <= '9') return digit - '0';
  if (digit >= 'A' && digit <= 'F') return digit - 'A' + 10;
  if (digit >= 'a' && digit <= 'f') return digit - 'a' + 10;
  return -1;
}

/// A number from 0 to `high`, or an empty field. False: anything else.
bool take_number(std::string_view field, double high, std::optional<double>& number) {
  number = decimal(field);
  if (field.empty()) return true;
  return number && *number >= 0 && *number <= high;
}
bool take_count(std::string_view field, std::optional<unsigned>& number) {
  number = digits(field);
  return field.empty() || number.has_value();
}

/// "4807.038" and "N", or "01131.000" and "W": two or three digits of degrees, then minutes.
bool take_angle(std::string_view field, std::string_view side, unsigned degree_digits,
                std::string_view sides, std::optional<double>& angle) {
  angle.reset();
  if (field.empty()) return true;
  const auto degrees = digits(field.substr(0, degree_digits));
  const auto minutes = decimal(field.substr(std::min<std::size_t>(degree_digits, field.size())));
  const bool is_side = side.size() == 1 && sides.find(side) != std::string_view::npos;
  if (!degrees || !minutes || *minutes < 0 || *minutes >= 60 || !is_side) return false;
  const double value = *degrees + *minutes / 60;
  if (value > (degree_digits == 2 ? 90 : 180)) return false;
  angle = side.front() == sides.front() ? value : -value;
  return true;
}
bool take_position(NmeaFields& fields, GpsReading& reading) {
  const std::string_view latitude = fields.next();
  const std::string_view north = fields.next();
  const std::string_view longitude = fields.next();
  const std::string_view east = fields.next();
  return latitude.empty() == longitude.empty() &&
         take_angle(latitude, north, 2, "NS", reading.latitude) &&
         take_angle(longitude, east, 3, "EW", reading.longitude);
}

/// "hhmmss" or "hhmmss.sss".
bool take_time(std::string_view field, std::optional<GpsTime>& time) {
  time.reset();
  if (field.empty()) return true;
  if (field.size() < 6) return false;
  const auto hour = digits(field.substr(0, 2));
  const auto minute = digits(field.substr(2, 2));
  const auto second = decimal(field.substr(4));
  if (!hour || !minute || !second || !digits(field.substr(4, 2))) return false;
  if (*hour > 23 || *minute > 59 || *second >= 61) return false;
  time = {.hour = *hour, .minute = *minute, .second = *second};
  return true;
}

bool take_date(std::optional<unsigned> day, std::optional<unsigned> month,
               std::optional<unsigned> year, std::optional<GpsDate>& date) {
  if (!day || !month || !year) return false;
  if (*day < 1 || *day > 31 || *month < 1 || *month > 12) return false;
  date = {.year = *year, .month = *month, .day = *day};
  return true;
}
/// "ddmmyy". The satellite system started in 1980.
bool take_short_date(std::string_view field, std::optional<GpsDate>& date) {
  date.reset();
  if (field.empty()) return true;
  if (field.size() != 6) return false;
  std::optional<unsigned> year = digits(field.substr(4, 2));
  if (year) *year += *year < 80 ? 2000U : 1900U;
  return take_date(digits(field.substr(0, 2)), digits(field.substr(2, 2)), year, date);
}

}  // namespace

void NmeaReceiver::receive(char byte) {
  if (byte == '\r' || byte == '\n') {
    end_line();
    return;
  }
  // A sentence starts, whatever came before it.
  if (byte == '$' && (length_ > 0 || is_broken_)) {
    ++counts_.garbage;
    length_ = 0;
    is_broken_ = false;
  }
  const bool is_first = length_ == 0 && !is_broken_;
  const bool is_text = byte >= ' ' && byte < 0x7F;
  if (!is_text || length_ == line_max || (is_first && byte != '$')) {
    is_broken_ = true;
    return;
  }
  if (!is_broken_) line_[length_++] = byte;
}

void NmeaReceiver::end_line() {
  const std::string_view line(line_.data(), length_);
  const bool was_broken = is_broken_;
  length_ = 0;
  is_broken_ = false;
  if (was_broken) {
    ++counts_.garbage;
  } else if (line.empty()) {
    return;
  } else if (!has_right_checksum(line)) {
    ++counts_.wrong_checksum;
  } else {
    take(line.substr(1, line.size() - 4));
  }
}

bool NmeaReceiver::has_right_checksum(std::string_view line) const {
  if (line.size() < 4 || line[line.size() - 3] != '*') return false;
  unsigned sum = 0;
  for (const char byte : line.substr(1, line.size() - 4)) sum ^= static_cast<unsigned char>(byte);
  const int high = hexadecimal(line[line.size() - 2]);
  const int low = hexadecimal(line[line.size() - 1]);
  return high >= 0 && low >= 0 && sum == static_cast<unsigned>(high * 16 + low);
}

void NmeaReceiver::take(std::string_view sentence) {
  constexpr std::string_view known_talkers = "GPGNGLGA";
  NmeaFields fields(sentence);
  const std::string_view name = fields.next();
  const std::size_t place = name.size() == 5 ? known_talkers.find(name.substr(0, 2)) : 1;
  const std::string_view kind = name.size() == 5 ? name.substr(2) : name;
  if (place % 2 != 0) {
    ++counts_.not_wanted;
    return;
  }
  // A fault in one field makes all of them doubtful: a copy is filled in.
  Said said = said_;
  bool is_sound = false;
  if (kind == "RMC") {
    is_sound = take_rmc(fields, said);
  } else if (kind == "GGA") {
    is_sound = take_gga(fields, said);
  } else if (kind == "GSA") {
    is_sound = take_gsa(fields, said);
  } else if (kind == "GSV") {
    is_sound = take_gsv(fields, said, place / 2);
  } else if (kind == "VTG") {
    is_sound = take_vtg(fields, said);
  } else if (kind == "ZDA") {
    is_sound = take_zda(fields, said);
  } else {
    ++counts_.not_wanted;
    return;
  }
  ++(is_sound ? counts_.accepted : counts_.malformed);
  if (is_sound) said_ = said;
}

bool NmeaReceiver::take_rmc(NmeaFields& fields, Said& said) {
  GpsReading& reading = said.reading;
  if (!take_time(fields.next(), reading.time)) return false;
  const std::string_view status = fields.next();
  if (status != "A" && status != "V") return false;
  said.is_valid = status == "A";
  if (!take_position(fields, reading)) return false;
  if (!take_number(fields.next(), 99999, reading.velocity)) return false;
  if (reading.velocity) *reading.velocity *= knot;
  if (!take_number(fields.next(), 360, reading.heading)) return false;
  return take_short_date(fields.next(), reading.date);
}

bool NmeaReceiver::take_gga(NmeaFields& fields, Said& said) {
  GpsReading& reading = said.reading;
  if (!take_time(fields.next(), reading.time) || !take_position(fields, reading)) return false;
  const auto quality = digits(fields.next());
  if (!quality || *quality > 8) return false;
  said.is_valid = *quality != 0;
  if (!take_count(fields.next(), reading.tracked_satellites)) return false;
  if (!take_number(fields.next(), 9999, reading.hdop)) return false;
  const std::string_view altitude = fields.next();
  const std::string_view unit = fields.next();
  reading.altitude = decimal(altitude);
  return altitude.empty() || (reading.altitude && unit == "M");
}

bool NmeaReceiver::take_gsa(NmeaFields& fields, Said& said) {
  fields.skip(1);
  const auto mode = digits(fields.next());
  if (!mode || *mode < 1 || *mode > 3) return false;
  said.dimensions = *mode == 1 ? GpsFix::none : *mode == 2 ? GpsFix::fix_2d : GpsFix::fix_3d;
  fields.skip(12);
  return take_number(fields.next(), 9999, said.reading.pdop) &&
         take_number(fields.next(), 9999, said.reading.hdop) &&
         take_number(fields.next(), 9999, said.reading.vdop);
}

bool NmeaReceiver::take_gsv(NmeaFields& fields, Said& said, std::size_t talker) {
  const auto sentences = digits(fields.next());
  const auto number = digits(fields.next());
  if (!sentences || !number || *number < 1 || *number > *sentences) return false;
  const std::string_view visible = fields.next();
  return !visible.empty() && take_count(visible, said.visible[talker]);
}

bool NmeaReceiver::take_vtg(NmeaFields& fields, Said& said) {
  GpsReading& reading = said.reading;
  if (!take_number(fields.next(), 360, reading.heading)) return false;
  fields.skip(3);
  std::optional<double> knots;
  if (!take_number(fields.next(), 99999, knots)) return false;
  fields.skip(1);
  std::optional<double> kilometres_per_hour;
  if (!take_number(fields.next(), 99999, kilometres_per_hour)) return false;
  reading.velocity.reset();
  if (kilometres_per_hour) {
    reading.velocity = *kilometres_per_hour / 3.6;
  } else if (knots) {
    reading.velocity = *knots * knot;
  }
  return true;
}

bool NmeaReceiver::take_zda(NmeaFields& fields, Said& said) {
  if (!take_time(fields.next(), said.reading.time)) return false;
  const std::string_view day = fields.next();
  const std::string_view month = fields.next();
  const std::string_view year = fields.next();
  if (!day.empty() || !month.empty() || !year.empty()) {
    return year.size() == 4 &&
           take_date(digits(day), digits(month), digits(year), said.reading.date);
  }
  said.reading.date.reset();
  return true;
}

GpsReading NmeaReceiver::reading() const {
  GpsReading reading = said_.reading;
  if (said_.is_valid == false) {
    reading.fix = GpsFix::none;
  } else if (said_.dimensions) {
    reading.fix = *said_.dimensions;
  } else if (said_.is_valid) {
    // At least a position: without GSA it is not known whether the height is known.
    reading.fix = GpsFix::fix_2d;
  }
  for (const std::optional<unsigned>& visible : said_.visible) {
    if (visible) reading.visible_satellites = reading.visible_satellites.value_or(0) + *visible;
  }
  if (reading.fix == GpsFix::none) {
    reading.latitude.reset();
    reading.longitude.reset();
    reading.altitude.reset();
    reading.velocity.reset();
    reading.heading.reset();
  }
  return reading;
}

void NmeaReceiver::forget() {
  said_ = {};
  length_ = 0;
  is_broken_ = false;
}

}  // namespace canvoy::cia447
