#include "canvoy/formats/gtfs/realtime.hpp"

#include <fmt/format.h>

#include <protozero/pbf_builder.hpp>

namespace canvoy::gtfs {

namespace {

// Field numbers of gtfs-realtime.proto.
enum class Message : protozero::pbf_tag_type { header = 1, entity = 2 };
enum class Header : protozero::pbf_tag_type { version = 1, incrementality = 2, timestamp = 3 };
enum class Entity : protozero::pbf_tag_type { id = 1, trip_update = 3, vehicle = 4 };
enum class TripDescriptor : protozero::pbf_tag_type {
  trip_id = 1,
  start_time = 2,
  start_date = 3,
  route_id = 5,
  direction_id = 6,
};
enum class Vehicle : protozero::pbf_tag_type { id = 1, label = 2 };
enum class Position : protozero::pbf_tag_type {
  latitude = 1,
  longitude = 2,
  bearing = 3,
  odometer = 4,
  speed = 5,
};
enum class VehiclePosition : protozero::pbf_tag_type {
  trip = 1,
  position = 2,
  stop_sequence = 3,
  status = 4,
  timestamp = 5,
  stop_id = 7,
  vehicle = 8,
  occupancy_status = 9,
  occupancy_percentage = 10,
};
enum class TripUpdate : protozero::pbf_tag_type {
  trip = 1,
  stop_time_update = 2,
  vehicle = 3,
  timestamp = 4,
  delay = 5,
};
enum class StopTimeUpdate : protozero::pbf_tag_type {
  stop_sequence = 1,
  arrival = 2,
  departure = 3,
  stop_id = 4,
  schedule_relationship = 5,
};
enum class StopTimeEvent : protozero::pbf_tag_type { delay = 1, time = 2 };

template <class Field>
using Builder = protozero::pbf_builder<Field>;

constexpr std::int32_t full_dataset = 0;
constexpr std::int32_t skipped = 1;

std::string date_text(const Date& date) {
  return fmt::format("{:04}{:02}{:02}", static_cast<int>(date.year()),
                     static_cast<unsigned>(date.month()), static_cast<unsigned>(date.day()));
}

std::string time_text(TimeOfDay time) {
  const auto seconds = time.count();
  return fmt::format("{:02}:{:02}:{:02}", seconds / 3600, seconds / 60 % 60, seconds % 60);
}

void write(Builder<TripDescriptor> out, const TripReference& trip) {
  out.add_string(TripDescriptor::trip_id, trip.trip);
  if (trip.start_time) out.add_string(TripDescriptor::start_time, time_text(*trip.start_time));
  if (trip.start_date) out.add_string(TripDescriptor::start_date, date_text(*trip.start_date));
  if (!trip.route.empty()) out.add_string(TripDescriptor::route_id, trip.route);
  if (trip.direction) out.add_uint32(TripDescriptor::direction_id, *trip.direction);
}

void write(Builder<Vehicle> out, const VehicleReference& vehicle) {
  out.add_string(Vehicle::id, vehicle.id);
  if (!vehicle.label.empty()) out.add_string(Vehicle::label, vehicle.label);
}

void write(Builder<Position> out, const VehicleReport& report) {
  out.add_float(Position::latitude, static_cast<float>(*report.latitude));
  out.add_float(Position::longitude, static_cast<float>(*report.longitude));
  if (report.bearing) out.add_float(Position::bearing, static_cast<float>(*report.bearing));
  if (report.odometer_m) out.add_double(Position::odometer, *report.odometer_m);
  if (report.speed_m_s) out.add_float(Position::speed, static_cast<float>(*report.speed_m_s));
}

void write(Builder<VehiclePosition> out, const VehicleReport& report) {
  using Field = VehiclePosition;
  if (report.trip) write(Builder<TripDescriptor>(out, Field::trip), *report.trip);
  if (report.latitude && report.longitude) {
    write(Builder<Position>(out, Field::position), report);
  }
  if (report.stop_sequence) out.add_uint32(Field::stop_sequence, *report.stop_sequence);
  if (report.status) out.add_enum(Field::status, static_cast<std::int32_t>(*report.status));
  if (report.timestamp != 0) out.add_uint64(Field::timestamp, report.timestamp);
  if (!report.stop.empty()) out.add_string(Field::stop_id, report.stop);
  write(Builder<Vehicle>(out, Field::vehicle), report.vehicle);
  if (report.occupancy) {
    out.add_enum(Field::occupancy_status, static_cast<std::int32_t>(*report.occupancy));
  }
  if (report.occupancy_percent) {
    out.add_uint32(Field::occupancy_percentage, *report.occupancy_percent);
  }
}

void write(Builder<StopTimeUpdate> out, const StopReport& stop) {
  using Field = StopTimeUpdate;
  out.add_uint32(Field::stop_sequence, stop.sequence);
  const auto write_event = [&out](Field field, std::optional<std::int32_t> delay_s,
                                  std::optional<std::int64_t> time) {
    if (!delay_s && !time) return;
    Builder<StopTimeEvent> event(out, field);
    if (delay_s) event.add_int32(StopTimeEvent::delay, *delay_s);
    if (time) event.add_int64(StopTimeEvent::time, *time);
  };
  write_event(Field::arrival, stop.arrival_delay_s, stop.arrival_time);
  write_event(Field::departure, stop.departure_delay_s, stop.departure_time);
  if (!stop.stop.empty()) out.add_string(Field::stop_id, stop.stop);
  if (stop.is_skipped) out.add_enum(Field::schedule_relationship, skipped);
}

void write(Builder<TripUpdate> out, const TripReport& report) {
  using Field = TripUpdate;
  write(Builder<TripDescriptor>(out, Field::trip), report.trip);
  for (const StopReport& stop : report.stops) {
    write(Builder<StopTimeUpdate>(out, Field::stop_time_update), stop);
  }
  write(Builder<Vehicle>(out, Field::vehicle), report.vehicle);
  if (report.timestamp != 0) out.add_uint64(Field::timestamp, report.timestamp);
  if (report.delay_s) out.add_int32(Field::delay, *report.delay_s);
}

/// A trip runs again on another day, and within a day if frequencies.txt has it.
std::string entity_id(const TripReference& trip) {
  std::string id = "trip-" + trip.trip;
  if (trip.start_date) id += "-" + date_text(*trip.start_date);
  if (trip.start_time) id += "-" + time_text(*trip.start_time);
  return id;
}

}  // namespace

std::string realtime_bytes(const RealtimeFeed& feed) {
  std::string bytes;
  Builder<Message> message(bytes);
  {
    Builder<Header> header(message, Message::header);
    header.add_string(Header::version, "2.0");
    header.add_enum(Header::incrementality, full_dataset);
    header.add_uint64(Header::timestamp, feed.timestamp);
  }
  for (const TripReport& report : feed.trips) {
    Builder<Entity> entity(message, Message::entity);
    entity.add_string(Entity::id, entity_id(report.trip));
    write(Builder<TripUpdate>(entity, Entity::trip_update), report);
  }
  for (const VehicleReport& report : feed.vehicles) {
    Builder<Entity> entity(message, Message::entity);
    entity.add_string(Entity::id, "vehicle-" + report.vehicle.id);
    write(Builder<VehiclePosition>(entity, Entity::vehicle), report);
  }
  return bytes;
}

}  // namespace canvoy::gtfs
